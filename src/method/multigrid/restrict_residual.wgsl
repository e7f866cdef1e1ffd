// Hands what smoothing has left down to the coarser level. One invocation per coarse node.
#include "gpu/index.wgsl"
#include "method/multigrid/restriction.wgsl"
//                                                                          elements
@group(0) @binding(0) var<uniform>             levels  : array<Level, 2>;
@group(0) @binding(1) var<storage, read_write> vectors : array<vec4f>;   // method/multigrid/level.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn restrict_residual(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < levels[1].nx * levels[1].ny) { restrict_node(levels[0], levels[1], node); }
}
