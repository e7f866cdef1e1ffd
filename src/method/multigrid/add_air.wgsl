// Adds the air to the equation of every free node: its force to the residual at the start of the unknown, and what it
// resists with on the matrix's diagonal. One invocation per node of a cloth, after `predict` or `predict_again`.
// Source: docs/air.md, equation 4.
#include "gpu/index.wgsl"
#include "method/air.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/spring.wgsl"
//                                                                                  elements       unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<uniform>             nodes           : ClothNodes;
@group(0) @binding(2) var<storage, read>       corners         : array<u32>;     // method/corners.wgsl
@group(0) @binding(3) var<storage, read>       position_in     : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(4) var<storage, read>       velocity_in     : array<vec4f>;   // vertex_count   m/s (w: 0 or 1)
@group(0) @binding(5) var<storage, read>       velocity_before : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(6) var<storage, read>       place           : array<vec4f>;   // count          m (w: N/m)
@group(0) @binding(7) var<storage, read_write> vectors         : array<vec4f>;   // cloth.wgsl: the finest
override kAgain : bool = false;  // in the second of two systems

fn vector_of(vector : u32, index : u32) -> u32 { return cloth * nodes.vectors + vector * nodes.count + index; }

// Where the unknown starts.
fn corner_place(vertex : u32) -> vec3f {
  let among_all = vertex - nodes.first_vertex;
  return place[among_all].xyz + vectors[vector_of(kFirst, among_all - cloth * nodes.count)].xyz;
}

// The velocity by which the air is linearised, m/s: as it will be, to the order of the formula. Where the air alone
// would stop the node within a step, only so much of the change before is taken as cannot make it swing.
fn velocity_ahead(vertex : u32, wind : vec3f, ratio : f32) -> vec3f {
  let v = velocity_in[vertex].xyz;
  let swing = step.time.dt * position_in[vertex].w * most_air_at(vertex, wind - v);
  return v + (ratio / max(1.0, swing)) * (v - velocity_before[vertex].xyz);
}

@compute @workgroup_size(kWorkgroupSize)
fn add_air(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  let among_all = cloth * nodes.count + index;
  if (place[among_all].w == 0.0) { return; }
  let vertex = nodes.first_vertex + among_all;
  let ratio = step.time.step_ratio * max(velocity_in[vertex].w, 0.0);
  let start_velocity = vectors[vector_of(kSecond, index)].xyz;
  let wind = wind_at(corner_place(vertex));
  var ahead = start_velocity;
  if (!kAgain) { ahead = velocity_ahead(vertex, wind, ratio); }
  let resistance = air_at(vertex, wind - ahead);
  let force = times(resistance, wind - start_velocity);
  vectors[vector_of(kResidual, index)] += vec4f(force, 0.0);
  let stiffness = scaled(1.0 / formula_of(ratio).he, resistance);
  vectors[vector_of(kAir, index)] = vec4f(stiffness.diagonal, stiffness.mixed.x);
  vectors[vector_of(kAir + 1u, index)] = vec4f(stiffness.mixed.yz, 0.0, 0.0);
}
