// Integrates every node under the forces that spring_forces summed (all x, all y, all z), and clears them. One
// invocation per node. Source: Sung et al., Algorithm 1, second part.
#include "gpu/index.wgsl"
#include "state/integrate.wgsl"
//                                                                               elements          unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       position_in  : array<vec4f>;   // vertex_count      m (w: 1/kg)
@group(0) @binding(2) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count      m/s
@group(0) @binding(3) var<storage, read>       rest         : array<vec4f>;   // vertex_count      m (w: motion)
@group(0) @binding(4) var<storage, read>       motions      : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(5) var<storage, read_write> force        : array<i32>;     // 3 * vertex_count  N * force_scale
@group(0) @binding(6) var<storage, read_write> position_out : array<vec4f>;   // vertex_count      m
@group(0) @binding(7) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count      m/s

@compute @workgroup_size(kWorkgroupSize)
fn integrate_forces(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let n = step.nodes.count;
  let sum = vec3f(f32(force[node]), f32(force[n + node]), f32(force[2u * n + node]));
  force[node] = 0;
  force[n + node] = 0;
  force[2u * n + node] = 0;
  let before = NodeState(position_in[node], velocity_in[node]);
  let after = integrate_node(node, before, sum / step.method.force_scale);
  position_out[node] = after.position;
  velocity_out[node] = after.velocity;
}
