// Moves every node of one colour of a body with volume to where its own part of what the substep minimises is least,
// its neighbours where they are. No two nodes of a colour are of one tetrahedron. One invocation per node.
// Source: docs/solvers/vbd.md, equations 3 and 4; docs/bodies.md, Node by node.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/solid_params.wgsl"
#include "method/symmetric.wgsl"
#include "method/vbd/gathered_color.wgsl"

//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             color       : GatheredColor;
@group(0) @binding(2) var<uniform>             solid       : SolidParams;
@group(0) @binding(3) var<storage, read>       lists       : array<u32>;      // nodes by colours; rows, entries
@group(0) @binding(4) var<storage, read>       corners     : array<vec4u>;    // tets
@group(0) @binding(5) var<storage, read>       rests       : array<vec4f>;    // 3 * tets      1/m, m³
@group(0) @binding(6) var<storage, read>       position_in : array<vec4f>;    // vertex_count  m
@group(0) @binding(7) var<storage, read>       aim         : array<vec4f>;    // vertex_count  m
@group(0) @binding(8) var<storage, read_write> way         : array<vec4f>;    // vertex_count  m (w: 1/kg)

// The pull of a tetrahedron at one of its corners, and how fast it grows against the corner's way: tet::corner_pull.
struct Pull {
  force : vec3f,        // N
  hessian : Symmetric,  // N/m
}

fn pull_of_tet(tet : u32, corner : u32) -> Pull {
  let at = corners[tet];
  let rest = rest_of_tet(tet);
  let law = solid.law;
  let x = position_in[at.x].xyz;
  let moved = way[at.x].xyz;
  let start = tet_deformation(rest, position_in[at.y].xyz - x, position_in[at.z].xyz - x, position_in[at.w].xyz - x);
  let change = tet_deformation(rest, way[at.y].xyz - moved, way[at.z].xyz - moved, way[at.w].xyz - moved);
  let f = start + change;
  let n = tet_slope(rest, corner);
  let square = dot(n, n);
  let rotation = rotation_of(law, f);
  var stress = tet_stress(law, f, rotation);
  var hessian : Symmetric;
  if (law.energy == kTetNeoHookean) {
    hessian = sum_of(identity(law.mu * square), outer(cofactor(f) * n, law.lambda + law.mu));
  } else {
    hessian = sum_of(identity(2.0 * law.mu * square), outer(rotation * n, law.lambda));
  }
  let delays = law.delay / step.time.dt;
  if (delays > 0.0) {
    stress += delays * (f * hooke(law, green_change(start, f, change)));
    let along = f * n;
    let across = delays * law.mu * square;
    hessian = sum_of(sum_of(hessian, outer(f[0], across)), sum_of(outer(f[1], across), outer(f[2], across)));
    hessian = sum_of(hessian, outer(along, delays * (law.mu + law.lambda)));
  }
  return Pull(-rest.volume * (stress * n), scaled(rest.volume, hessian));
}

@compute @workgroup_size(kWorkgroupSize)
fn descend_solid(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= color.count) { return; }
  let node = lists[color.first + index];
  let own = way[node];
  if (own.w == 0.0) { return; }
  let mobility = step.time.dt * step.time.dt * own.w;  // m/N
  var slope = aim[node].xyz - own.xyz;
  var hessian = identity(1.0);
  let row = color.rows + node - color.first_node;
  for (var at = lists[row]; at < lists[row + 1u]; at++) {
    let entry = lists[color.rows + at];
    let pull = pull_of_tet(entry / 4u, entry % 4u);
    slope += mobility * pull.force;
    hessian = sum_of(hessian, scaled(mobility, pull.hessian));
  }
  way[node] = vec4f(own.xyz + times(inverse(hessian), slope), own.w);
}
