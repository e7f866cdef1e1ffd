// Adds the force of every spring to its two nodes. One invocation per spring.
// Source: Sung et al., Algorithm 1. WGSL has no f32 atomics, so forces are fixed point at force_scale units per
// newton, the largest power of two for which no node's sum can overflow (src/method/mass_spring/fixed_point.hpp).
// Integer sums do not depend on thread order.
#include "method/mass_spring/fixed_force.wgsl"
#include "gpu/index.wgsl"
#include "element/spring/packed_spring.wgsl"
//                                                                           elements          unit
@group(0) @binding(0) var<uniform>             step     : StepBlock;
@group(0) @binding(1) var<storage, read>       position : array<vec4f>;       // vertex_count      m
@group(0) @binding(2) var<storage, read>       velocity : array<vec4f>;       // vertex_count      m/s
@group(0) @binding(3) var<storage, read>       springs  : array<Spring>;      // spring_count
@group(0) @binding(4) var<storage, read>       kinds    : array<SpringKind>;
@group(0) @binding(5) var<storage, read_write> force    : array<atomic<i32>>; // 3 * vertex_count  N * force_scale

fn add_force(node : u32, f : vec3i) {
  atomicAdd(&force[node], f.x);
  atomicAdd(&force[step.nodes.count + node], f.y);
  atomicAdd(&force[2u * step.nodes.count + node], f.z);
}

@compute @workgroup_size(kWorkgroupSize)
fn spring_forces(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= step.method.spring_count) { return; }
  let s = springs[index];
  let node_b = s.node_b_and_kind & ((1u << kSpringNodeBits) - 1u);
  let kind = kinds[s.node_b_and_kind >> kSpringNodeBits];
  let span = position[node_b].xyz - position[s.node_a].xyz;
  let rate = velocity[node_b].xyz - velocity[s.node_a].xyz;
  let f = fixed_force(span, rate, s.rest_length, kind.stiffness, kind.damping);
  add_force(s.node_a, f);
  add_force(node_b, -f);
}
