// Adds the correction of the coarser level of a mesh. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/mesh_prolongation.wgsl"
//                                                                             elements
@group(0) @binding(0) var<uniform>             levels  : array<MeshLevel, 2>;
@group(0) @binding(1) var<storage, read_write> vectors : array<vec4f>;      // method/multigrid/vectors.wgsl
@group(0) @binding(2) var<storage, read>       taps    : array<Share>;      // kTaps of each node: of nodes of the coarser level

@compute @workgroup_size(kWorkgroupSize)
fn mesh_prolong(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < levels[0].node_count) { prolong_node(levels[0], levels[1], node); }
}
