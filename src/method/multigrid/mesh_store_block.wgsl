// Keeps an entry of a mesh's matrix, as mesh_block.wgsl reads it. The including kernel binds `blocks`.
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/symmetric.wgsl"

fn store_block(entry : u32, value : Symmetric) {
  blocks[3u * entry] = value.diagonal.xy;
  blocks[3u * entry + 1u] = vec2f(value.diagonal.z, value.mixed.x);
  blocks[3u * entry + 2u] = value.mixed.yz;
}
