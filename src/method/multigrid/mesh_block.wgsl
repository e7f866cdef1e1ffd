// The entries of a mesh's matrices, in three vec2f each: xx, yy; zz, yz; xz, xy. The including kernel binds `blocks`.
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/symmetric.wgsl"

fn block_of(entry : u32) -> Symmetric {
  let a = blocks[3u * entry];
  let b = blocks[3u * entry + 1u];
  let c = blocks[3u * entry + 2u];
  return Symmetric(vec3f(a, b.x), vec3f(b.y, c));
}
