// What smoothing has left on a coarse level. One invocation per node.
#include "shared/index.wgsl"
#include "multigrid/coarse_steps.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             levels    : LevelPair;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;   // multigrid/level.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec4f>;   // multigrid/coarse_block.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn residual(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < levels.fine.nx * levels.fine.ny) { residual_node(levels.fine, node); }
}
