// The forces of a body's tetrahedra on their corners. One invocation per tetrahedron. Source: docs/bodies.md, The laws.
#include "gpu/index.wgsl"
#include "method/solid_params.wgsl"
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>             solid    : SolidParams;
@group(0) @binding(1) var<storage, read>       corners  : array<vec4u>;    // tets
@group(0) @binding(2) var<storage, read>       rests    : array<vec4f>;    // 3 * tets      1/m, m³: solid_buffers.hpp
@group(0) @binding(3) var<storage, read>       position : array<vec4f>;    // vertex_count  m
@group(0) @binding(4) var<storage, read>       velocity : array<vec4f>;    // vertex_count  m/s
@group(0) @binding(5) var<storage, read_write> forces   : array<vec4f>;    // 4 * tets      N

@compute @workgroup_size(kWorkgroupSize)
fn solid_forces(@builtin(global_invocation_id) id : vec3u) {
  let tet = flat_index(id);
  if (tet >= solid.tets) { return; }
  let at = corners[tet];
  let rest = rest_of_tet(tet);
  let x = position[at.x].xyz;
  let v = velocity[at.x].xyz;
  let f = tet_deformation(rest, position[at.y].xyz - x, position[at.z].xyz - x, position[at.w].xyz - x);
  var stress = tet_stress(solid.law, f, rotation_of(solid.law, f));
  if (solid.law.delay > 0.0) {
    let rate = tet_deformation(rest, velocity[at.y].xyz - v, velocity[at.z].xyz - v, velocity[at.w].xyz - v);
    stress += tet_damping_stress(solid.law, f, rate);
  }
  let own = tet_forces(rest, stress);
  forces[4u * tet] = own.a;
  forces[4u * tet + 1u] = own.b;
  forces[4u * tet + 2u] = own.c;
  forces[4u * tet + 3u] = own.d;
}
