// The first smoothing sweep on a level of a mesh, after the correction. One invocation per node.
#include "method/multigrid/mesh_smoothing.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn mesh_smooth_begin(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { begin_smoothing(levels[0], kFirst, kSecond, node); }
}
