// What the last change of the ways adds to the pulls of every tetrahedron at its corners, turned as the cycle began.
// One invocation per tetrahedron. Source: docs/solvers/projective_dynamics.md, equation 4 and Bodies.
#include "gpu/index.wgsl"
#include "method/solid_params.wgsl"
#include "method/projective_dynamics/turned_tet.wgsl"
//                                                                              elements      unit
@group(0) @binding(0) var<uniform>             solid       : SolidParams;
@group(0) @binding(1) var<storage, read>       corners     : array<vec4u>;      // tets
@group(0) @binding(2) var<storage, read>       rests       : array<vec4f>;      // 3 * tets      1/m, m³
@group(0) @binding(3) var<storage, read>       turned      : array<TurnedTet>;  // tets
@group(0) @binding(4) var<storage, read>       change      : array<vec4f>;      // vertex_count  m
@group(0) @binding(5) var<storage, read_write> pulls       : array<vec4f>;      // 4 * tets      N

@compute @workgroup_size(kWorkgroupSize)
fn pull_tets_back(@builtin(global_invocation_id) id : vec3u) {
  let tet = flat_index(id);
  if (tet >= solid.tets) { return; }
  let at = corners[tet];
  let rest = rest_of_tet(tet);
  let t = turned[tet];
  let a = change[at.x].xyz;
  let f = tet_deformation(rest, change[at.y].xyz - a, change[at.z].xyz - a, change[at.w].xyz - a);
  let rotation = mat3x3f(t.first.xyz, t.second.xyz, t.third.xyz);
  let stress = t.first.w * f + (t.second.w * contraction(rotation, f)) * rotation;
  let own = tet_forces(rest, stress);
  pulls[4u * tet] = own.a;
  pulls[4u * tet + 1u] = own.b;
  pulls[4u * tet + 2u] = own.c;
  pulls[4u * tet + 3u] = own.d;
}
