// The end of a substep in which obstacles were answered: where its way has taken every node, and the velocity that this
// is, without what restores a gap. A velocity's w is kHistory, or -1 where an obstacle holds the node by all that
// presses it (contact/proximity/evaluate.wgsl). One invocation per node.
// Source: docs/solvers/vbd.md, equations 5 and 7; docs/solvers/xpbd.md, equation 6.
#include "gpu/index.wgsl"
#include "method/holds/node_holds.wgsl"
//                                                                               elements            unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       position_in  : array<vec4f>;   // vertex_count        m (w: 1/kg)
@group(0) @binding(2) var<storage, read_write> position_out : array<vec4f>;   // vertex_count        m; comes as the way
@group(0) @binding(3) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count        m/s
@group(0) @binding(4) var<storage, read>       aim          : array<vec4f>;   // 4 * vertex_count    m

override kHistory : f32 = 0.0;  // as in end_way.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn end_held_way(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let before = position_in[node];
  let way = position_out[node];
  let at = hold_at(node);
  let hold = aim[at + 2u];
  let bears = (hold.y == kBears) & (way.w > 0.0);
  let moved = way.xyz - select(0.0, hold.x, bears) * aim[at].xyz;
  position_out[node] = vec4f(before.xyz + way.xyz, before.w);
  velocity_out[node] = vec4f(moved / step.time.dt, select(kHistory, -1.0, bears & (hold.z != 0.0)));
}
