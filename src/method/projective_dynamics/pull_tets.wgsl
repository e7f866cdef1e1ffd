// The start of a cycle over every tetrahedron of a corotated body: what it pulls its corners by, and what its matrix
// stays by. One invocation per tetrahedron. Source: docs/solvers/projective_dynamics.md, Bodies.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/solid_params.wgsl"
#include "method/tet_turning.wgsl"
#include "method/projective_dynamics/turned_tet.wgsl"
//                                                                              elements      unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             solid       : SolidParams;
@group(0) @binding(2) var<storage, read>       corners     : array<vec4u>;      // tets
@group(0) @binding(3) var<storage, read>       rests       : array<vec4f>;      // 3 * tets      1/m, m³
@group(0) @binding(4) var<storage, read>       position_in : array<vec4f>;      // vertex_count  m
@group(0) @binding(5) var<storage, read>       way         : array<vec4f>;      // vertex_count  m
@group(0) @binding(6) var<storage, read_write> turned      : array<TurnedTet>;  // tets
@group(0) @binding(7) var<storage, read_write> pulls       : array<vec4f>;      // 4 * tets      N

@compute @workgroup_size(kWorkgroupSize)
fn pull_tets(@builtin(global_invocation_id) id : vec3u) {
  let tet = flat_index(id);
  if (tet >= solid.tets) { return; }
  let at = corners[tet];
  let rest = rest_of_tet(tet);
  let law = solid.law;
  let x = position_in[at.x].xyz;
  let moved = way[at.x].xyz;
  let start = tet_deformation(rest, position_in[at.y].xyz - x, position_in[at.z].xyz - x, position_in[at.w].xyz - x);
  let f = start + tet_deformation(rest, way[at.y].xyz - moved, way[at.z].xyz - moved, way[at.w].xyz - moved);
  let rotation = nearest_rotation(f);
  var stress = tet_stress(law, f, rotation);
  let delays = law.delay / step.time.dt;
  if (delays > 0.0) { stress += delays * delayed_stress(law, start, f, rotation); }

  let back = transpose(rotation);
  let least = (1.0 + delays) * 2.0 * law.mu;
  let most = least + (1.0 + delays) * 3.0 * law.lambda;
  let across = clamp(turning(symmetric_part(back * f), symmetric_part(back * stress)), least,
                     max(least, most));
  turned[tet] = TurnedTet(vec4f(rotation[0], across), vec4f(rotation[1], (most - across) / 3.0),
                          vec4f(rotation[2], 0.0));

  let own = tet_forces(rest, stress);
  pulls[4u * tet] = own.a;
  pulls[4u * tet + 1u] = own.b;
  pulls[4u * tet + 2u] = own.c;
  pulls[4u * tet + 3u] = own.d;
}
