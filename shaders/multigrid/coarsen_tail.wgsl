// The matrices of the coarsest levels, from that of the first of them. One workgroup does all, since each is small.
#include "shared/index.wgsl"
#include "multigrid/galerkin_product.wgsl"
//                                                                            elements
@group(0) @binding(0) var<storage, read>       tail      : array<Level>;   // the first of them, and all coarser ones
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;   // multigrid/level.wgsl
@group(0) @binding(2) var<storage, read_write> operators : array<vec4f>;   // multigrid/coarse_block.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn coarsen_tail(@builtin(local_invocation_index) local : u32) {
  for (var l = 1u; l < arrayLength(&tail); l++) {
    let coarse = tail[l];
    for (var node = local; node < coarse.nx * coarse.ny; node += kWorkgroupSize) { coarsen(tail[l - 1u], coarse, node); }
    storageBarrier();
  }
}
