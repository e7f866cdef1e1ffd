// Answers the pushes summed at the predicted positions, and clears them. One invocation per node.
// Source: Sung et al., Algorithm 2: the mean push from the previous position; velocity × -0.5.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
//                                                                         elements      unit
@group(0) @binding(0) var<uniform>             step     : StepBlock;
@group(0) @binding(1) var<storage, read>       previous : array<vec4f>; // vertex_count  m
@group(0) @binding(2) var<storage, read_write> pushes   : array<vec4i>; // vertex_count  m * push_scale; w: count
@group(0) @binding(3) var<storage, read_write> position : array<vec4f>; // vertex_count  m
@group(0) @binding(4) var<storage, read_write> velocity : array<vec4f>; // vertex_count  m/s
const kRestitution = -0.5;

@compute @workgroup_size(kWorkgroupSize)
fn contact_response(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let push = pushes[node];
  if (push.w == 0) { return; }
  pushes[node] = vec4i(0);
  let mean = vec3f(push.xyz) / (step.contact.push_scale * f32(push.w));
  position[node] = vec4f(previous[node].xyz + mean, position[node].w);
  velocity[node] = vec4f(kRestitution * velocity[node].xyz, 0.0);
}
