// Takes what obstacles press the nodes with in the substep, and clears the sums. Nothing has been projected yet. One
// invocation per node. Source: docs/solvers/xpbd.md, Obstacles.
#include "gpu/index.wgsl"
#include "method/holds/take_hold.wgsl"
//                                                                               elements            unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<storage, read>       velocity_in : array<vec4f>;    // vertex_count        m/s
@group(0) @binding(2) var<storage, read_write> presses     : array<i32>;      // press_sums.wgsl
@group(0) @binding(3) var<storage, read_write> aim         : array<vec4f>;    // 4 * vertex_count    m

@compute @workgroup_size(kWorkgroupSize)
fn begin_holds(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  aim[node] = vec4f(0.0);
  take_hold(node, velocity_in[node].xyz);
}
