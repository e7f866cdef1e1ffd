// Adds the coarser level's correction, and takes the first step of smoothing from there. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/coarse_steps.wgsl"
#include "method/multigrid/correction.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             levels    : array<Level, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;   // method/multigrid/level.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;   // method/multigrid/coarse_block.wgsl

fn operand(level : Level, node : u32) -> vec3f {
  let j = node / level.nx;
  return vectors[vector_at(level, kFirst, node)].xyz + correction(level, levels[1], node - j * level.nx, j);
}

@compute @workgroup_size(kWorkgroupSize)
fn prolong_coarse(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < levels[0].nx * levels[0].ny) { prolong_node(levels[0], node); }
}
