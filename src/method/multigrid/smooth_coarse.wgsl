// The second step of smoothing on a coarse level. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/coarse_steps.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             levels    : array<Level, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;   // method/multigrid/level.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;   // method/multigrid/coarse_block.wgsl
override kFrom : u32;  // kDirection on the way down, where the solution is the first step; kSecond on the way up
override kTo : u32;

fn operand(level : Level, node : u32) -> vec3f { return vectors[vector_at(level, kFrom, node)].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn smooth_coarse(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < levels[0].nx * levels[0].ny) { smooth_node(levels[0], kTo, kKeep, kTake, node); }
}
