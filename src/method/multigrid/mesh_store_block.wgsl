// Keeps an entry of a mesh's matrix, as mesh_block.wgsl reads it.
#include "method/multigrid/mesh_block.wgsl"

fn store_block(entry : u32, value : Block) {
  let first = block_words() * entry;
  let symmetric = value.symmetric;
  blocks[first] = symmetric.diagonal.xy;
  blocks[first + 1u] = vec2f(symmetric.diagonal.z, symmetric.mixed.x);
  blocks[first + 2u] = symmetric.mixed.yz;
  if (!kGeneral) { return; }
  blocks[first + 3u] = value.skew.xy;
  blocks[first + 4u] = vec2f(value.skew.z, 0.0);
}
fn store_symmetric(entry : u32, value : Symmetric) { store_block(entry, Block(value, vec3f(0.0))); }
