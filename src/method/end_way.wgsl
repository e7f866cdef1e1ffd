// The end of a substep of a method that moves ways: where its way has taken every node, and the velocity that this is.
// One invocation per node. Source: docs/solvers/xpbd.md, equation 6; docs/solvers/vbd.md, equation 5.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(2) var<storage, read_write> position_out : array<vec4f>;   // vertex_count   m; comes as the way
@group(0) @binding(3) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count   m/s (w: history)
override kHistory : f32 = 0.0;  // 1: the next substep may look back on the motion (Method::history)

@compute @workgroup_size(kWorkgroupSize)
fn end_way(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let before = position_in[node];
  let way = position_out[node].xyz;
  position_out[node] = vec4f(before.xyz + way, before.w);
  velocity_out[node] = vec4f(way / step.time.dt, kHistory);
}
