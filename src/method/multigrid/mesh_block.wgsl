// The blocks of a mesh's matrices, in two vec4f each: xx, yy, zz, yz and xz, xy. The including kernel binds `blocks`.
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/symmetric.wgsl"

fn block_of(level : Level, number : u32) -> Symmetric {
  let at = 2u * (level.first_block + number);
  let a = blocks[at];
  return Symmetric(a.xyz, vec3f(a.w, blocks[at + 1u].xy));
}
