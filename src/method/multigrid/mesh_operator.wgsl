// A x on a level of a mesh. The including kernel binds `vectors`, `blocks`, `row_starts` and `rows`, and has
// operand(level, x, node).
#include "method/multigrid/mesh_block.wgsl"

fn product(level : Level, x : u32, node : u32) -> vec3f {
  var sum = times(block_of(level, node), operand(level, x, node));
  let list = level.first_row + node;
  for (var k = row_starts[list]; k < row_starts[list + 1u]; k++) {
    let coupling = rows[k];
    sum += times(block_of(level, coupling.block), operand(level, x, coupling.node));
  }
  return sum;
}
