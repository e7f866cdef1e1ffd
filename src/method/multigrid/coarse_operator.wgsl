// A x on a coarse level of a grid. The including kernel binds `operators` and has the field, operand(level, x, node).
#include "method/multigrid/bending.wgsl"
#include "method/multigrid/grid_block.wgsl"

fn coupled(level : Level, x : u32, owner : u32, number : u32, other : u32) -> vec3f {
  return times(block_at(level, owner, number), operand(level, x, other));
}

// Reads are free of branches, so that all are in flight at once: a missing neighbour is replaced by the node itself.
// A block that a node has towards one is 0 then.
fn product(level : Level, x : u32, node : u32) -> vec3f {
  let j = node / level.nx;
  let i = node - j * level.nx;
  let has_left = i > 0u;
  let has_up = j > 0u;
  let has_right = i + 1u < level.nx;
  let left = select(0u, 1u, has_left);
  let right = select(0u, 1u, has_right);
  let up = select(0u, level.nx, has_up);
  let down = select(0u, level.nx, j + 1u < level.ny);
  let zero = vec3f(0.0);
  return coupled(level, x, node, 0u, node) +
         coupled(level, x, node, 1u, node + right) +
         select(zero, coupled(level, x, node - left, 1u, node - left), has_left) +
         coupled(level, x, node, 2u, node + down) +
         select(zero, coupled(level, x, node - up, 2u, node - up), has_up) +
         coupled(level, x, node, 3u, node + down + right) +
         select(zero, coupled(level, x, node - up - left, 3u, node - up - left), has_up && has_left) +
         coupled(level, x, node, 4u, node + down - left) +
         select(zero, coupled(level, x, node - up + right, 4u, node - up + right), has_up && has_right) +
         bending_product(level, x, i, j, node);
}
