// The matrix of a coarse level from that of the finer one. One invocation per coarse node and block. Source: docs/solvers/multigrid.md, equation 10.
#include "gpu/index.wgsl"
#include "method/multigrid/galerkin_product.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             levels    : array<Level, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;   // method/multigrid/level.wgsl
@group(0) @binding(2) var<storage, read_write> operators : array<vec2f>;   // method/multigrid/coarse_block.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn galerkin(@builtin(global_invocation_id) id : vec3u) {
  let count = levels[1].nx * levels[1].ny;
  let index = flat_index(id);
  if (index < kBlocks * count) { coarsen(levels[0], levels[1], index % count, index / count); }
}
