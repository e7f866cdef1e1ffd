// The first smoothing sweep on a level of a mesh, after the correction. kLanes invocations per node.
#include "method/multigrid/mesh_smoothing.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn mesh_smooth_begin(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  let node = flat_index(id) / kLanes;
  let is_idle = node >= node_count(levels[0]) || is_solved();
  share_product(levels[0], kFirst, node, local, is_idle);
  if (!is_idle && local % kLanes == 0u) { begin_smoothing(levels[0], kFirst, kSecond, node); }
}
