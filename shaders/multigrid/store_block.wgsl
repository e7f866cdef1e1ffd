// Keeps a block of a coarse level's matrix, as coarse_block.wgsl reads it. The including kernel binds `operators`.
#include "multigrid/coarse_block.wgsl"

fn store_block(level : Level, node : u32, number : u32, block : Symmetric) {
  operators[operator_at(level, kBlockParts * number, node)] = block.diagonal.xy;
  operators[operator_at(level, kBlockParts * number + 1u, node)] = vec2f(block.diagonal.z, block.mixed.x);
  operators[operator_at(level, kBlockParts * number + 2u, node)] = block.mixed.yz;
}
