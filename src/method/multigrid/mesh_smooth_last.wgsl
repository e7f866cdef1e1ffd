// The last smoothing sweep of a V-cycle on a mesh, and r·z. kLanes invocations per node.
#include "method/multigrid/mesh_smoothing.wgsl"
#include "method/multigrid/smooth_last.wgsl"
//                                                                                 elements
@group(0) @binding(5) var<storage, read_write> partials : array<vec2f>;        // one a kChunk nodes

@compute @workgroup_size(kWorkgroupSize)
fn mesh_smooth_last(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  end_cycle(levels[0], local, flat_index(id) / kLanes);
}
