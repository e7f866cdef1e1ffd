// The direction of an iteration, and its product with the matrix, on the finest level of a grid. One invocation per
// node.
#include "gpu/index.wgsl"
#include "method/multigrid/fine_bindings.wgsl"
#include "method/multigrid/fine_operator.wgsl"
#include "method/multigrid/lone_lane.wgsl"
#include "method/multigrid/search.wgsl"
//                                                                                 elements
@group(0) @binding(7) var<storage, read_write> partials  : array<vec2f>;       // one a kChunk nodes
@group(0) @binding(8) var<storage, read_write> pair_sums : array<u32>;         // state/pair_holds.wgsl
@group(0) @binding(9) var<uniform>             nodes     : ClothNodes;

@compute @workgroup_size(kWorkgroupSize)
fn search_fine(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = id.z;
  let level = levels[0];
  let node = flat_index(id);
  search_from(level, local, node, node < node_count(level) && place[among_all(level, node)].w > 0.0);
}
