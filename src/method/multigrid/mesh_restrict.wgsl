// Restricts the residual after smoothing on a level of a mesh to the coarser one. One invocation per coarse node.
#include "gpu/index.wgsl"
#include "method/multigrid/level_left.wgsl"
#include "method/multigrid/mesh_restriction.wgsl"
#include "method/multigrid/solve.wgsl"
//                                                                                     elements
@group(0) @binding(0) var<uniform>             levels        : array<MeshLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors       : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       source_starts : array<u32>;          // node_count + 1 of each level
@group(0) @binding(3) var<storage, read>       sources       : array<Share>;        // of nodes of the finer level

@compute @workgroup_size(kWorkgroupSize)
fn mesh_restrict(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[1]) && !is_solved()) { restrict_node(levels[0], levels[1], node); }
}
