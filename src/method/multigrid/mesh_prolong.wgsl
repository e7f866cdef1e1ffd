// Adds the correction of the coarser level of a mesh. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/keep_vector.wgsl"
#include "method/multigrid/level_solution.wgsl"
#include "method/multigrid/mesh_correction.wgsl"
#include "method/multigrid/solve.wgsl"
//                                                                               elements
@group(0) @binding(0) var<uniform>             levels  : array<MeshLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       taps    : array<Share>;        // kTaps a node: coarser nodes

@compute @workgroup_size(kWorkgroupSize)
fn mesh_prolong(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < node_count(levels[0]) && !is_solved()) { correct_node(levels[0], levels[1], node); }
}
