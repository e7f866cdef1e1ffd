// The first smoothing sweep on the finest level of a grid after its correction. One invocation per node.
#include "method/multigrid/fine_level.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn prolong_fine(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { begin_smoothing(levels[0], kFirst, kSecond, node); }
}
