// The direction of an iteration, and its product with the matrix, on the finest level of a mesh. kLanes invocations per
// node.
#include "gpu/index.wgsl"
#include "method/multigrid/mesh_operator.wgsl"
#include "method/multigrid/search.wgsl"
//                                                                                  elements
@group(0) @binding(0) var<uniform>             levels     : array<MeshLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors    : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       blocks     : array<vec2f>;        // method/multigrid/mesh_block.wgsl
@group(0) @binding(3) var<storage, read>       row_starts : array<u32>;          // node_count + 1 of each level
@group(0) @binding(4) var<storage, read>       entries    : array<u32>;          // the node of each
@group(0) @binding(5) var<storage, read_write> partials   : array<vec2f>;        // one a kChunk nodes
@group(0) @binding(6) var<storage, read>       place      : array<vec4f>;        // node_count  w: N/m, 0: fixed
@group(0) @binding(7) var<storage, read_write> pair_sums  : array<u32>;          // state/pair_holds.wgsl
@group(0) @binding(8) var<uniform>             nodes      : ClothNodes;

@compute @workgroup_size(kWorkgroupSize)
fn mesh_search(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  search_from(levels[0], local, flat_index(id) / kLanes, true);
}
