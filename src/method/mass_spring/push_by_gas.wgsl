// Takes the gas in closed cloths into the step of every free node, after all other forces but the air's. One invocation
// per node. Source: docs/pressure.md, equation 4.
#include "gpu/index.wgsl"
#include "method/gas_force.wgsl"
#include "state/grab.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       gases        : array<Gas>;
@group(0) @binding(2) var<storage, read>       slopes       : array<vec4f>;   // vertex_count   m² (w: 1 + gas, or 0)
@group(0) @binding(3) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(4) var<storage, read>       rest         : array<vec4f>;   // vertex_count   m (w: motion)
@group(0) @binding(5) var<storage, read>       motions      : array<vec4f>;   // grab.wgsl
@group(0) @binding(6) var<storage, read_write> position_out : array<vec4f>;   // vertex_count   m
@group(0) @binding(7) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count   m/s

@compute @workgroup_size(kWorkgroupSize)
fn push_by_gas(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let before = position_in[node];
  if (slopes[node].w == 0.0 || before.w == 0.0 || is_grabbed(node)) { return; }
  let velocity = velocity_out[node].xyz + step.time.dt * before.w * gas_force(node);
  position_out[node] = vec4f(before.xyz + step.time.dt * velocity, before.w);
  velocity_out[node] = vec4f(velocity, 0.0);
}
