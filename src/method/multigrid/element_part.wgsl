// Blocks of a matrix without its inertia, as sums of what elements are for two nodes. The including kernel binds
// `levels`, `place`, `parts`, `targets`, `entries` and `blocks`, and has block_of_part(part).
#include "method/multigrid/mesh_store_block.wgsl"

// A part is its element's number, its kind, and two corners. Mirror: src/method/multigrid/element_pairs.hpp.
fn element_of(part : u32) -> u32 { return part >> 6u; }
fn kind_of(part : u32) -> u32 { return (part >> 4u) & 3u; }
fn row_of(part : u32) -> u32 { return (part >> 2u) & 3u; }
fn column_of(part : u32) -> u32 { return part & 3u; }

fn sum_block(number : u32) {
  let level = levels[0];
  if (number >= level.block_count) { return; }
  var sum = Block(zero_matrix(), vec3f(0.0));
  for (var part = parts[number]; part < parts[number + 1u]; part++) {
    sum = block_sum(sum, block_of_part(parts[part]));
  }
  let at = targets[number];
  if (number < level.node_count) {
    store_symmetric(at.x, sum.symmetric);
    return;
  }
  let is_fixed = place[entries[at.x]].w == 0.0 || place[entries[at.y]].w == 0.0;
  sum = block_scaled(select(1.0, 0.0, is_fixed), sum);
  store_block(at.x, sum);
  store_block(at.y, Block(sum.symmetric, -sum.skew));
}
