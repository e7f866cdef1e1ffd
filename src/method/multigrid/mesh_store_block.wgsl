// Keeps a block of a mesh's matrix, as mesh_block.wgsl reads it. The including kernel binds `blocks`.
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/symmetric.wgsl"

fn store_block(level : Level, number : u32, value : Symmetric) {
  let at = 2u * (level.first_block + number);
  blocks[at] = vec4f(value.diagonal, value.mixed.x);
  blocks[at + 1u] = vec4f(value.mixed.yz, 0.0, 0.0);
}
