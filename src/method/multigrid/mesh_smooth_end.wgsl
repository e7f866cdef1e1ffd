// The second smoothing sweep on a level of a mesh. One invocation per node.
#include "method/multigrid/mesh_smoothing.wgsl"
override kFrom : u32;  // kDirection on the way down, where the solution is the first sweep; kSecond on the way up

@compute @workgroup_size(kWorkgroupSize)
fn mesh_smooth_end(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { end_smoothing(levels[0], kFrom, kFirst, node); }
}
