// The direction of an iteration, and its product with the matrix, on the finest level of a grid. One invocation per
// node.
#include "gpu/index.wgsl"
#include "method/multigrid/fine_operator.wgsl"
#include "method/multigrid/search.wgsl"
//                                                                                elements       unit
@group(0) @binding(0) var<uniform>             step     : StepBlock;
@group(0) @binding(1) var<uniform>             grid     : SpringGrid;
@group(0) @binding(2) var<uniform>             levels   : array<GridLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       place    : array<vec4f>;        // nx * ny        m (w: N/m; 0: fixed)
@group(0) @binding(4) var<storage, read>       holds    : array<vec4f>;        // method/multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors  : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(6) var<storage, read_write> partials : array<vec2f>;        // one a kChunk nodes

@compute @workgroup_size(kWorkgroupSize)
fn search_fine(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  let node = flat_index(id);
  search_from(levels[0], local, node, node < arrayLength(&place) && place[node].w > 0.0);
}
