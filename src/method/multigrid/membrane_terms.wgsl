// The membranes of a cloth in the linear system of a substep: their forces where the unknown starts, and how these
// change with the places of their corners. One invocation per triangle. Source: docs/solvers/multigrid.md, Fabric.
#include "gpu/index.wgsl"
#include "element/membrane/hessian.wgsl"
#include "method/fabric_params.wgsl"
#include "method/multigrid/lead.wgsl"
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/membrane_term.wgsl"
#include "method/multigrid/spring.wgsl"
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>             step    : StepBlock;
@group(0) @binding(1) var<uniform>             fabric  : FabricParams;
@group(0) @binding(2) var<uniform>             levels  : array<MeshLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       corners : array<u32>;      // 3 * triangles
@group(0) @binding(4) var<storage, read>       slopes  : array<vec4f>;    // triangles     1/m: membrane/build.hpp
@group(0) @binding(5) var<storage, read>       place   : array<vec4f>;    // node_count    m
@group(0) @binding(6) var<storage, read>       vectors : array<vec4f>;    // method/multigrid/cloth.wgsl
@group(0) @binding(7) var<storage, read_write> terms   : array<vec4f>;    // method/multigrid/membrane_term.wgsl
@group(0) @binding(8) var<storage, read_write> forces  : array<vec4f>;    // 3 * triangles + 4 * hinges, N

fn store_term(triangle : u32, h : MembraneHessian) {
  let warp = symmetric_of(h.warp);
  let weft = symmetric_of(h.weft);
  let mixed = symmetric_of(h.mixed);
  let skew = skew_of(h.mixed);
  let first = kTermWords * triangle;
  terms[first] = vec4f(warp.diagonal, warp.mixed.x);
  terms[first + 1u] = vec4f(warp.mixed.yz, weft.diagonal.xy);
  terms[first + 2u] = vec4f(weft.diagonal.z, weft.mixed);
  terms[first + 3u] = vec4f(mixed.diagonal, mixed.mixed.x);
  terms[first + 4u] = vec4f(mixed.mixed.yz, skew.xy);
  terms[first + 5u] = vec4f(skew.z, 0.0, 0.0, 0.0);
}

fn vector_of(vector : u32, node : u32) -> vec3f { return vectors[vector_at(levels[0], vector, node)].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn membrane_terms(@builtin(global_invocation_id) id : vec3u) {
  let triangle = flat_index(id);
  if (triangle >= fabric.triangles) { return; }
  let a = corners[3u * triangle] - fabric.first;
  let b = corners[3u * triangle + 1u] - fabric.first;
  let c = corners[3u * triangle + 2u] - fabric.first;
  let slope = slopes[triangle];
  let f = deformation(slope, place[b].xyz - place[a].xyz, place[c].xyz - place[a].xyz);
  let start = vector_of(kFirst, a);
  let way = deformation(slope, vector_of(kFirst, b) - start, vector_of(kFirst, c) - start);
  let velocity = vector_of(kSecond, a);
  let change = deformation(slope, vector_of(kSecond, b) - velocity, vector_of(kSecond, c) - velocity);

  let lead = lead_of(dot(way.warp, way.warp) + dot(way.weft, way.weft));
  let at = Axes(f.warp + lead * way.warp, f.weft + lead * way.weft);
  let left = 1.0 - lead;
  let elastic = membrane_hessian(fabric.law, at);
  let still = membrane_stress(fabric.law, at, Axes(vec3f(0.0), vec3f(0.0)));
  let pulled = hessian_times(elastic, Axes(left * way.warp, left * way.weft));
  let later = damping_lead(lead);
  let damped = damping_stress(fabric.law, Axes(f.warp + later * way.warp, f.weft + later * way.weft), change);
  let found = membrane_forces(slope, Axes(still.warp + pulled.warp + damped.warp,
                                          still.weft + pulled.weft + damped.weft));
  forces[3u * triangle] = vec4f(-(found.second + found.third), 0.0);
  forces[3u * triangle + 1u] = vec4f(found.second, 0.0);
  forces[3u * triangle + 2u] = vec4f(found.third, 0.0);

  let rate = 1.0 / formula_of(step.time.step_ratio).he;
  var held = elastic;
  if (!kLeads) { held = held_membrane_hessian(fabric.law, at, way); }
  let damped_by_place = hessian_sum(held, hessian_scaled(rate, damping_hessian(fabric.law, at)));
  store_term(triangle, hessian_scaled(area_of(slope), damped_by_place));
}
