// The way of every node in this substep without its springs, where the springs are then projected: along its motion, to
// the hand, or by inertia, gravity, gas and air. It comes as the gas's force, N. One invocation per node.
// Source: docs/solvers/xpbd.md, equation 1.
#include "gpu/index.wgsl"
#include "method/way_velocity.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<storage, read>       position_in : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(2) var<storage, read>       velocity_in : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(3) var<storage, read>       rest        : array<vec4f>;   // vertex_count   m (w: motion)
@group(0) @binding(4) var<storage, read>       motions     : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(5) var<storage, read_write> way         : array<vec4f>;   // vertex_count   m (w: 1/kg; 0: driven)
@group(0) @binding(6) var<storage, read>       corners     : array<u32>;     // method/corners.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn predict_way(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let before = NodeState(position_in[node], velocity_in[node]);
  let velocity = way_velocity(node, before, way[node]);
  way[node] = vec4f(step.time.dt * velocity, way_mobility(node, before));
}
