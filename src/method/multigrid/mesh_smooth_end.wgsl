// The second smoothing sweep on a level of a mesh. kLanes invocations per node.
#include "method/multigrid/mesh_smoothing.wgsl"
override kFrom : u32;  // kDirection on the way down, where the solution is the first sweep; kSecond on the way up

@compute @workgroup_size(kWorkgroupSize)
fn mesh_smooth_end(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  let node = flat_index(id) / kLanes;
  let is_idle = node >= node_count(levels[0]) || is_solved();
  share_product(levels[0], kFrom, node, local, is_idle);
  if (!is_idle && local % kLanes == 0u) { end_smoothing(levels[0], kFrom, kFirst, node); }
}
