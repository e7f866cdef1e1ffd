// Keeps a block of a coarse level's matrix, as grid_block.wgsl reads it. The including kernel binds `operators`.
#include "method/multigrid/grid_block.wgsl"

fn store_block(level : Level, node : u32, number : u32, value : Symmetric) {
  operators[operator_at(level, kBlockParts * number, node)] = value.diagonal.xy;
  operators[operator_at(level, kBlockParts * number + 1u, node)] = vec2f(value.diagonal.z, value.mixed.x);
  operators[operator_at(level, kBlockParts * number + 2u, node)] = value.mixed.yz;
}
