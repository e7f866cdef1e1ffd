// Takes what obstacles press the nodes with in the substep, and clears the sums. A node that would bear against them
// alone begins from where that takes it; or where its neighbours have just pulled it against that, goes on as they did.
// One invocation per node. Source: docs/solvers/vbd.md, Obstacles.
#include "gpu/index.wgsl"
#include "method/holds/held_way.wgsl"
#include "method/holds/take_hold.wgsl"
//                                                                                   elements            unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       velocity_in     : array<vec4f>;    // vertex_count       m/s
@group(0) @binding(2) var<storage, read>       velocity_before : array<vec4f>;    // vertex_count       m/s
@group(0) @binding(3) var<storage, read_write> presses         : array<i32>;      // press_sums.wgsl
@group(0) @binding(4) var<storage, read_write> aim             : array<vec4f>;    // 4 * vertex_count   m
@group(0) @binding(5) var<storage, read_write> way             : array<vec4f>;    // vertex_count       m (w: 1/kg)

fn begun_way(node : u32) -> vec3f {
  let alone = held_way(node, aim[node].xyz, identity(1.0), identity(1.0));
  if (aim[hold_at(node) + 2u].y != kBears) { return way[node].xyz; }
  let velocity = velocity_in[node];
  let going_on = step.time.dt * velocity.xyz;
  let change = alone - going_on;
  let felt = step.time.dt * step.time.step_ratio * (velocity.xyz - velocity_before[node].xyz);
  if (velocity.w >= 0.0 || !(dot(felt, change) < 0.0)) { return alone; }
  return going_on + min(1.0, length(change) / length(felt)) * felt;
}

@compute @workgroup_size(kWorkgroupSize)
fn begin_holds(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  if (!take_hold(node, velocity_in[node].xyz)) { return; }
  if (way[node].w > 0.0) { way[node] = vec4f(begun_way(node), way[node].w); }
}
