// Restricts the residual after smoothing on a level of a grid to the coarser one. One invocation per coarse node.
#include "gpu/index.wgsl"
#include "method/multigrid/grid_restriction.wgsl"
#include "method/multigrid/level_left.wgsl"
#include "method/multigrid/solve.wgsl"
//                                                                               elements
@group(0) @binding(0) var<uniform>             levels  : array<GridLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors : array<vec4f>;        // method/multigrid/cloth.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn restrict_residual(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let node = flat_index(id);
  if (node < node_count(levels[1]) && !is_solved()) { restrict_node(levels[0], levels[1], node); }
}
