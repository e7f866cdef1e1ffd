// A x on a coarse level. The including kernel binds `operators` and has the field, operand(level, node).
#include "method/multigrid/bending.wgsl"
#include "method/multigrid/coarse_block.wgsl"

fn coupled(level : Level, owner : u32, number : u32, other : u32) -> vec3f {
  return times(block_at(level, owner, number), operand(level, other));
}

// Nothing is read in a branch, so that all is read at once: where there is no neighbour, the node itself stands for it. A block that a node
// has towards one is 0 then.
fn coarse_product(level : Level, i : u32, j : u32, node : u32) -> vec3f {
  let has_left = i > 0u;
  let has_up = j > 0u;
  let has_right = i + 1u < level.nx;
  let left = select(0u, 1u, has_left);
  let right = select(0u, 1u, has_right);
  let up = select(0u, level.nx, has_up);
  let down = select(0u, level.nx, j + 1u < level.ny);
  let zero = vec3f(0.0);
  return coupled(level, node, 0u, node) +
         coupled(level, node, 1u, node + right) +
         select(zero, coupled(level, node - left, 1u, node - left), has_left) +
         coupled(level, node, 2u, node + down) +
         select(zero, coupled(level, node - up, 2u, node - up), has_up) +
         coupled(level, node, 3u, node + down + right) +
         select(zero, coupled(level, node - up - left, 3u, node - up - left), has_up && has_left) +
         coupled(level, node, 4u, node + down - left) +
         select(zero, coupled(level, node - up + right, 4u, node - up + right), has_up && has_right) +
         bending_product(level, i, j, node);
}
