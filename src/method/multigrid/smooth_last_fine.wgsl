// The last smoothing sweep of a V-cycle on a grid, and r·z. One invocation per node.
#include "method/multigrid/fine_level.wgsl"
#include "method/multigrid/lone_lane.wgsl"
#include "method/multigrid/smooth_last.wgsl"
//                                                                                 elements
@group(0) @binding(7) var<storage, read_write> partials : array<vec2f>;        // one a kChunk nodes

@compute @workgroup_size(kWorkgroupSize)
fn smooth_last_fine(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = id.z;
  end_cycle(levels[0], local, flat_index(id));
}
