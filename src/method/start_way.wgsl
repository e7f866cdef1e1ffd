// Where a node would go in this substep without its springs, and the way from which a method that seeks the end of a
// substep begins: the same, with as much of the change of its velocity as it followed in the substep before. It comes
// as the gas's force, N. One invocation per node. Source: docs/solvers/vbd.md, equations 1 and 2.
#include "gpu/index.wgsl"
#include "method/way_velocity.wgsl"
//                                                                                  elements       unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       position_in     : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(2) var<storage, read>       velocity_in     : array<vec4f>;   // vertex_count   m/s (w: or 0)
@group(0) @binding(3) var<storage, read>       velocity_before : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(4) var<storage, read>       rest            : array<vec4f>;   // vertex_count   m (w: motion)
@group(0) @binding(5) var<storage, read>       motions         : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(6) var<storage, read_write> aim             : array<vec4f>;   // vertex_count   m
@group(0) @binding(7) var<storage, read_write> way             : array<vec4f>;   // vertex_count   m (w: 1/kg; 0: held)
@group(0) @binding(8) var<storage, read>       corners         : array<u32>;     // method/corners.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn start_way(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let before = NodeState(position_in[node], velocity_in[node]);
  var velocity = way_velocity(node, before, way[node]);
  let driven = is_prescribed(node, before);
  aim[node] = vec4f(step.time.dt * velocity, 0.0);
  let change = velocity - before.velocity.xyz;
  let square = dot(change, change);
  if (!driven && before.velocity.w != 0.0 && step.time.step_ratio > 0.0 && square > 0.0) {
    let felt = step.time.step_ratio * (before.velocity.xyz - velocity_before[node].xyz);
    velocity = before.velocity.xyz + saturate(dot(felt, change) / square) * change;
  }
  way[node] = vec4f(step.time.dt * velocity, way_mobility(node, before));
}
