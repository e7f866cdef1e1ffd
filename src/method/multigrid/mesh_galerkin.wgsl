// The matrix of a coarse level of a mesh, Pᵀ A P, and the inverse of its diagonal. One invocation per block: a sum of
// entries of the finer level. Source: docs/solvers/multigrid.md, equation 12.
#include "gpu/index.wgsl"
#include "method/multigrid/mesh_store_block.wgsl"
#include "method/multigrid/level_start.wgsl"
#include "method/multigrid/mesh_inverse.wgsl"
//                                                                                      elements
@group(0) @binding(0) var<uniform>             levels         : array<MeshLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors        : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read_write> blocks         : array<vec2f>;        // method/multigrid/mesh_block.wgsl
@group(0) @binding(3) var<storage, read>       product_starts : array<u32>;          // block_count + 1 of each level
@group(0) @binding(4) var<storage, read>       products       : array<Share>;        // of entries of the finer level
@group(0) @binding(5) var<storage, read>       targets        : array<vec2u>;        // the entries of each block

// Of the list that ends there: without weight beyond its end.
fn product_at(k : u32, end : u32) -> Share {
  let product = products[min(k, end - 1u)];
  return Share(product.index, select(0.0, product.weight, k < end));
}

@compute @workgroup_size(kWorkgroupSize)
fn mesh_galerkin(@builtin(global_invocation_id) id : vec3u) {
  let number = flat_index(id);
  let coarse = levels[1];
  if (number >= coarse.block_count) { return; }
  let list = coarse.first_product + number;
  let end = product_starts[list + 1u];
  var sum = Block(zero_matrix(), vec3f(0.0));
  for (var k = product_starts[list]; k < end; k += 4u) {  // each waits for memory, so four at a time
    let a = product_at(k, end);
    let b = product_at(k + 1u, end);
    let c = product_at(k + 2u, end);
    let d = product_at(k + 3u, end);
    let block_a = block_of(a.index);
    let block_b = block_of(b.index);
    let block_c = block_of(c.index);
    let block_d = block_of(d.index);
    sum = block_sum(block_sum(sum, block_scaled(a.weight, block_a)), block_scaled(b.weight, block_b));
    sum = block_sum(block_sum(sum, block_scaled(c.weight, block_c)), block_scaled(d.weight, block_d));
  }
  if (number < coarse.node_count) {  // on the diagonal: what is not symmetric cancels
    store_symmetric(targets[list].x, sum.symmetric);
    store_inverse(coarse, number, inverse_for_sweeps(sum.symmetric));
    return;
  }
  store_block(targets[list].x, sum);
  store_block(targets[list].y, Block(sum.symmetric, -sum.skew));
}
