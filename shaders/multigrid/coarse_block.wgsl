// Blocks of the matrices of coarse levels: of a node its own, and those towards (i+1, j), (i, j+1), (i+1, j+1) and (i-1, j+1). Thirty
// numbers in eight vec4f. The including kernel binds `operators`.
#include "multigrid/level.wgsl"
#include "multigrid/symmetric.wgsl"
const kBlocks = 5u;

fn block_at(level : Level, node : u32, number : u32) -> Symmetric {
  let a = operators[operator_at(level, number, node)];
  let b = operators[operator_at(level, kBlocks + number / 2u, node)];
  return Symmetric(a.xyz, vec3f(a.w, select(b.xy, b.zw, (number & 1u) == 1u)));
}
