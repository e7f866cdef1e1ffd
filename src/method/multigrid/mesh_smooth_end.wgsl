// The second step of smoothing on a level of a mesh. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/mesh_steps.wgsl"
//                                                                                elements
@group(0) @binding(0) var<uniform>             levels     : array<MeshLevel, 2>;
@group(0) @binding(1) var<storage, read_write> vectors    : array<vec4f>;      // method/multigrid/vectors.wgsl
@group(0) @binding(2) var<storage, read>       blocks     : array<vec4f>;      // method/multigrid/mesh_block.wgsl
@group(0) @binding(3) var<storage, read>       row_starts : array<u32>;        // node_count + 1 of each level
@group(0) @binding(4) var<storage, read>       rows       : array<Coupling>;
override kFrom : u32;  // kDirection on the way down, where the solution is the first step; kFirst on the way up
override kTo : u32;

@compute @workgroup_size(kWorkgroupSize)
fn mesh_smooth_end(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < levels[0].node_count) { end_smoothing(levels[0], kFrom, kTo, node); }
}
