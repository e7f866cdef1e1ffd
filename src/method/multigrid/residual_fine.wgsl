// The residual after smoothing on the finest level of a grid, 0 where a node is fixed. One invocation per node.
#include "method/multigrid/fine_level.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn residual_fine(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let level = levels[0];
  let node = flat_index(id);
  if (node >= node_count(level) || is_solved()) { return; }
  if (place[among_all(level, node)].w > 0.0) {
    keep_residual(level, node);
  } else {
    vectors[vector_at(level, kDirection, node)] = vec4f(0.0);
  }
}
