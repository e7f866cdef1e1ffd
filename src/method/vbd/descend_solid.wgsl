// Moves every node of one colour of a body with volume to where its own part of what the substep minimises is least,
// its neighbours where they are. No two nodes of a colour are of one tetrahedron. One invocation per node.
// Source: docs/solvers/vbd.md, equations 3 and 4; docs/bodies.md, Node by node.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/solid_params.wgsl"
#include "method/vbd/gathered_color.wgsl"

//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             color       : GatheredColor;
@group(0) @binding(2) var<uniform>             solid       : SolidParams;
@group(0) @binding(3) var<storage, read>       lists       : array<u32>;      // nodes by colours; rows, entries
@group(0) @binding(4) var<storage, read>       corners     : array<vec4u>;    // tets
@group(0) @binding(5) var<storage, read>       rests       : array<vec4f>;    // 3 * tets      1/m, m³
@group(0) @binding(6) var<storage, read>       position_in : array<vec4f>;    // vertex_count  m
@group(0) @binding(7) var<storage, read_write> aim         : array<vec4f>;    // vertex_count  m
@group(0) @binding(8) var<storage, read_write> way         : array<vec4f>;    // vertex_count  m (w: 1/kg)

// tet::corner_pull.
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

fn pull_of(entry : u32) -> Pull { return pull_of_tet(entry / 4u, entry % 4u); }

@compute @workgroup_size(kWorkgroupSize)
fn descend_solid(@builtin(global_invocation_id) id : vec3u) { descend(flat_index(id)); }
