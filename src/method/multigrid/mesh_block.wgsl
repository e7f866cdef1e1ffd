// The entries of a mesh's matrices: a symmetric part in three vec2f, xx, yy; zz, yz; xz, xy; and of fabric two more for
// s of the rest, v -> s x v: x, y; z, 0. The including kernel binds `blocks`.
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/block.wgsl"
override kGeneral : bool = false;  // blocks of two nodes have that rest

fn block_words() -> u32 { return select(3u, 5u, kGeneral); }

fn block_of(entry : u32) -> Block {
  let first = block_words() * entry;
  let a = blocks[first];
  let b = blocks[first + 1u];
  let c = blocks[first + 2u];
  var skew = vec3f(0.0);
  if (kGeneral) { skew = vec3f(blocks[first + 3u], blocks[first + 4u].x); }
  return Block(Symmetric(vec3f(a, b.x), vec3f(b.y, c)), skew);
}

fn mesh_block_times(a : Block, v : vec3f) -> vec3f {
  let product = times(a.symmetric, v);
  if (!kGeneral) { return product; }
  return product + cross(a.skew, v);
}
