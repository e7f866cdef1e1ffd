// Adds the coarser level's correction on a coarse level of a grid, and takes the first smoothing sweep from there.
// One invocation per node.
#include "method/multigrid/coarse_level.wgsl"
#include "method/multigrid/grid_transfer.wgsl"

fn operand(level : Level, x : u32, node : u32) -> vec3f {
  return vectors[vector_at(level, x, node)].xyz + correction(level, levels[1], node);
}

@compute @workgroup_size(kWorkgroupSize)
fn prolong_coarse(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { begin_smoothing(levels[0], kFirst, kSecond, node); }
}
