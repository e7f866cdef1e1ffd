// A x on a level of a mesh. The including kernel binds `vectors`, `blocks`, `row_starts` and `rows`, and has
// operand(level, x, node).
#include "method/multigrid/mesh_block.wgsl"

fn product(level : Level, x : u32, node : u32) -> vec3f {
  var sum = times(block_of(level, node), operand(level, x, node));
  let list = level.first_row + node;
  let end = row_starts[list + 1u];
  for (var k = row_starts[list]; k < end; k += 4u) {  // each waits for memory, so four at a time
    let a = rows[k];
    let b = rows[min(k + 1u, end - 1u)];
    let c = rows[min(k + 2u, end - 1u)];
    let d = rows[min(k + 3u, end - 1u)];
    let block_a = block_of(level, a.block);
    let block_b = block_of(level, b.block);
    let block_c = block_of(level, c.block);
    let block_d = block_of(level, d.block);
    let x_a = operand(level, x, a.node);
    let x_b = select(vec3f(0.0), operand(level, x, b.node), k + 1u < end);
    let x_c = select(vec3f(0.0), operand(level, x, c.node), k + 2u < end);
    let x_d = select(vec3f(0.0), operand(level, x, d.node), k + 3u < end);
    sum = sum + times(block_a, x_a) + times(block_b, x_b) + times(block_c, x_c) + times(block_d, x_d);
  }
  return sum;
}
