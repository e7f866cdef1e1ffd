// The end of a substep in which obstacles were answered: where its way has taken every node, and the velocity that this
// is, without what restores a gap, and with what a blow gives back. A velocity's w is kHistory, or -1 where an obstacle
// holds the node by all that presses it (contact/proximity/evaluate.wgsl). One invocation per node.
// Source: docs/solvers/vbd.md, equations 5, 7 and 8; docs/solvers/xpbd.md, equation 6.
#include "contact/proximity/friction.wgsl"
#include "gpu/index.wgsl"
#include "method/holds/node_holds.wgsl"
//                                                                               elements            unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       position_in  : array<vec4f>;   // vertex_count        m (w: 1/kg)
@group(0) @binding(2) var<storage, read_write> position_out : array<vec4f>;   // vertex_count        m; comes as the way
@group(0) @binding(3) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count        m/s
@group(0) @binding(4) var<storage, read>       aim          : array<vec4f>;   // 4 * vertex_count    m

override kHistory : f32 = 0.0;  // as in end_way.wgsl

// After the blow a node leaves the surface as fast as restitution has it, and friction takes its part of that too.
fn gone_back(v : vec3f, at : u32) -> vec3f {
  let n = aim[at].xyz;
  let own = v - aim[at + 1u].xyz / step.time.dt;
  let more = aim[at + 2u].w - dot(n, own);
  if (aim[at + 2u].w == 0.0 || more <= 0.0) { return v; }
  return v + more * n - no_longer(part_across(own, n), aim[at + 1u].w * more);
}

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
  var v = moved / step.time.dt;
  if (bears) { v = gone_back(v, at); }
  velocity_out[node] = vec4f(v, select(kHistory, -1.0, bears & (hold.z != 0.0)));
}
