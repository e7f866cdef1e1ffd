// A x on a coarse level. The including kernel binds `operators` and has the field, operand(level, node).
#include "multigrid/bending.wgsl"
#include "multigrid/coarse_block.wgsl"

fn coupled(level : Level, owner : u32, number : u32, other : u32) -> vec3f {
  return times(block_at(level, owner, number), operand(level, other));
}

fn coarse_product(level : Level, i : u32, j : u32, node : u32) -> vec3f {
  let nx = level.nx;
  let left = i > 0u;
  let right = i + 1u < nx;
  let up = j > 0u;
  let down = j + 1u < level.ny;
  var sum = coupled(level, node, 0u, node);
  if (right) { sum += coupled(level, node, 1u, node + 1u); }
  if (left) { sum += coupled(level, node - 1u, 1u, node - 1u); }
  if (down) { sum += coupled(level, node, 2u, node + nx); }
  if (up) { sum += coupled(level, node - nx, 2u, node - nx); }
  if (right && down) { sum += coupled(level, node, 3u, node + nx + 1u); }
  if (left && up) { sum += coupled(level, node - nx - 1u, 3u, node - nx - 1u); }
  if (left && down) { sum += coupled(level, node, 4u, node + nx - 1u); }
  if (right && up) { sum += coupled(level, node - nx + 1u, 4u, node - nx + 1u); }
  return sum + bending_product(level, i, j, node);
}
