// What smoothing has left on a coarse level. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/coarse_steps.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             levels    : array<Level, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;   // method/multigrid/level.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;   // method/multigrid/coarse_block.wgsl

fn operand(level : Level, node : u32) -> vec3f { return vectors[vector_at(level, kFirst, node)].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn residual_coarse(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < levels[0].nx * levels[0].ny) { residual_node(levels[0], node); }
}
