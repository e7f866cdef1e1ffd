// Blocks of the matrices of a grid's coarse levels: of a node its own, and those towards (i+1, j), (i, j+1), (i+1, j+1)
// and (i-1, j+1); 0 where there is no such node. A block is six numbers in three vec2f. The including kernel binds
// `operators`.
#include "method/multigrid/grid_level.wgsl"
#include "method/symmetric.wgsl"
const kBlocks = 5u;
const kBlockParts = 3u;

fn block_at(level : Level, node : u32, number : u32) -> Symmetric {
  let a = operators[operator_at(level, kBlockParts * number, node)];
  let b = operators[operator_at(level, kBlockParts * number + 1u, node)];
  let c = operators[operator_at(level, kBlockParts * number + 2u, node)];
  return Symmetric(vec3f(a, b.x), vec3f(b.y, c));
}
