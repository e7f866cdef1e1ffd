// The second smoothing sweep on a coarse level of a grid. One invocation per node.
#include "method/multigrid/coarse_level.wgsl"
#include "method/multigrid/operand.wgsl"
override kFrom : u32;  // kDirection on the way down, where the solution is the first sweep; kSecond on the way up

@compute @workgroup_size(kWorkgroupSize)
fn smooth_coarse(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { end_smoothing(levels[0], kFrom, kFirst, node); }
}
