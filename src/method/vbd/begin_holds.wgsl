// Takes what obstacles press the nodes with in the substep, and clears the sums. A node that would bear against them
// alone begins from where that takes it; or where its neighbours have just pulled it against that, goes on as they did.
// One invocation per node. Source: docs/solvers/vbd.md, Obstacles.
#include "gpu/index.wgsl"
#include "contact/proximity/pressed_vertex.wgsl"
#include "method/vbd/descended.wgsl"
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
  let at = hold_at(node);
  aim[at + 2u] = vec4f(0.0, kFree, 0.0, 0.0);
  let pressed = pressed_vertex(node);
  if (pressed.weight == 0.0) { return; }
  clear_presses(node);
  let size = length(pressed.normal);
  if (size < kAgree * pressed.weight) { return; }
  let n = pressed.normal / size;
  let part = min(1.0, kHoldRate * step.time.dt / kHoldPart);
  let restored = min(part * pressed.gap, kHoldSpeed * step.time.dt);
  let ahead = step.time.dt * dot(n, velocity_in[node].xyz);
  aim[at] = vec4f(n, ahead + pressed.lack - (pressed.gap - restored));
  // Friction is of what all pairs bear, which where they press apart is more than their sum.
  aim[at + 1u] = vec4f(step.time.dt * pressed.surface, pressed.friction * pressed.weight / size);
  aim[at + 2u] = vec4f(restored, kPressed, select(0.0, 1.0, size >= kAlike * pressed.weight), 0.0);
  if (way[node].w > 0.0) { way[node] = vec4f(begun_way(node), way[node].w); }
}
