// Takes the air into the step of every free node, after all other forces have been. One invocation per node.
// Source: docs/air.md, equation 3.
#include "gpu/index.wgsl"
#include "method/air_step.wgsl"
#include "state/grab.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       corners      : array<u32>;     // method/corners.wgsl
@group(0) @binding(2) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(3) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(4) var<storage, read>       rest         : array<vec4f>;   // vertex_count   m (w: motion)
@group(0) @binding(5) var<storage, read>       motions      : array<vec4f>;   // grab.wgsl
@group(0) @binding(6) var<storage, read_write> position_out : array<vec4f>;   // vertex_count   m
@group(0) @binding(7) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count   m/s

@compute @workgroup_size(kWorkgroupSize)
fn push_by_air(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let before = NodeState(position_in[node], velocity_in[node]);
  if (before.position.w == 0.0 || is_grabbed(node)) { return; }
  let velocity = velocity_in_air(node, before, velocity_out[node].xyz);
  position_out[node] = vec4f(before.position.xyz + step.time.dt * velocity, before.position.w);
  velocity_out[node] = vec4f(velocity, 0.0);
}
