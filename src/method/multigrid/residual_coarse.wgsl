// The residual after smoothing on a coarse level of a grid. One invocation per node.
#include "method/multigrid/coarse_level.wgsl"
#include "method/multigrid/operand.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn residual_coarse(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { keep_residual(levels[0], node); }
}
