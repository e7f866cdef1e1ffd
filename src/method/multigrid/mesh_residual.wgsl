// The residual after smoothing on a level of a mesh. One invocation per node.
#include "method/multigrid/mesh_smoothing.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn mesh_residual(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { keep_residual(levels[0], node); }
}
