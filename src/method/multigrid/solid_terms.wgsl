// The tetrahedra of a body in the linear system of a substep: their forces where the unknown starts, and how these
// change with the places of their corners. One invocation per tetrahedron. Source: docs/bodies.md, All nodes at once.
#include "gpu/index.wgsl"
#include "method/multigrid/lead.wgsl"
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/solid_term.wgsl"
#include "method/multigrid/spring.wgsl"
#include "method/solid_params.wgsl"
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>             step    : StepBlock;
@group(0) @binding(1) var<uniform>             solid   : SolidParams;
@group(0) @binding(2) var<uniform>             levels  : array<MeshLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       corners : array<vec4u>;    // tets
@group(0) @binding(4) var<storage, read>       rests   : array<vec4f>;    // 3 * tets      1/m, m³: solid_buffers.hpp
@group(0) @binding(5) var<storage, read>       place   : array<vec4f>;    // node_count    m
@group(0) @binding(6) var<storage, read>       vectors : array<vec4f>;    // method/multigrid/cloth.wgsl
@group(0) @binding(7) var<storage, read_write> terms   : array<vec4f>;    // of all bodies: solid_term.wgsl
@group(0) @binding(8) var<storage, read_write> forces  : array<vec4f>;    // 4, of all     N

fn vector_of(vector : u32, node : u32) -> vec3f { return vectors[vector_at(levels[0], vector, node)].xyz; }

fn change_of(rest : TetRest, vector : u32, at : vec4u) -> mat3x3f {
  let first = vector_of(vector, at.x);
  return tet_deformation(rest, vector_of(vector, at.y) - first, vector_of(vector, at.z) - first,
                         vector_of(vector, at.w) - first);
}

fn store_tet_term(tet : u32, frame : TetFrame, rest : TetRest, h : TetHessian) {
  let first = kTetTermWords * tet;
  let turned = transpose(frame.v);
  terms[first] = vec4f(frame.u[0], h.stretch[0].x);
  terms[first + 1u] = vec4f(frame.u[1], h.stretch[1].y);
  terms[first + 2u] = vec4f(frame.u[2], h.stretch[2].z);
  terms[first + 3u] = vec4f(turned * rest.b, h.stretch[1].z);
  terms[first + 4u] = vec4f(turned * rest.c, h.stretch[0].z);
  terms[first + 5u] = vec4f(turned * rest.d, h.stretch[0].y);
  terms[first + 6u] = vec4f(h.onward, h.crossed.x);
  terms[first + 7u] = vec4f(h.back, h.crossed.y);
  terms[first + 8u] = vec4f(h.crossed.z, 0.0, 0.0, 0.0);
}

@compute @workgroup_size(kWorkgroupSize)
fn solid_terms(@builtin(global_invocation_id) id : vec3u) {
  let tet = flat_index(id);
  if (tet >= solid.tets) { return; }
  let at = corners[tet] - vec4u(solid.first);
  let rest = rest_of_tet(tet);
  let law = solid.law;
  let x = place[at.x].xyz;
  let f = tet_deformation(rest, place[at.y].xyz - x, place[at.z].xyz - x, place[at.w].xyz - x);
  let way = change_of(rest, kFirst, at);
  let lead = lead_of(contraction(way, way));
  let there = f + lead * way;
  let rotation = nearest_rotation(there);
  let frame = tet_frame(there, rotation);
  let elastic = tet_hessian(law, frame);
  var stress = tet_stress(law, there, rotation) + tet_hessian_times(frame, elastic, (1.0 - lead) * way);
  if (law.delay > 0.0) {
    stress += tet_damping_stress(law, f + damping_lead(lead) * way, change_of(rest, kSecond, at));
  }
  let own = tet_forces(rest, stress);
  let among_all = solid.first_tet + tet;
  forces[4u * among_all] = own.a;
  forces[4u * among_all + 1u] = own.b;
  forces[4u * among_all + 2u] = own.c;
  forces[4u * among_all + 3u] = own.d;

  let rate = 1.0 / formula_of(step.time.step_ratio).he;
  var held = elastic;
  if (!kLeads) { held = held_tet_hessian(law, frame, elastic, way); }
  let damped = tet_hessian_sum(held, tet_hessian_scaled(rate, tet_damping_hessian(law, frame)));
  store_tet_term(among_all, frame, rest, tet_hessian_scaled(rest.volume, damped));
}
