// Quadratic bending of a level: k/2 |x(m-1) - 2 x(m) + x(m+1)|² about the nodes m of each row and column. The including
// file has the field that it is applied to, operand(level, x, node).
#include "method/multigrid/grid_level.wgsl"

fn line_bending(level : Level, x : u32, at : u32, end : u32, node : u32, to_next : u32) -> vec3f {
  let own = operand(level, x, node);
  var sum = vec3f(0.0);
  if (at > 1u && at <= end) {
    sum += operand(level, x, node - 2u * to_next) - 2.0 * operand(level, x, node - to_next) + own;
  }
  if (at > 0u && at < end) {
    sum -= 2.0 * (operand(level, x, node - to_next) - 2.0 * own + operand(level, x, node + to_next));
  }
  if (at + 1u < end) {
    sum += own - 2.0 * operand(level, x, node + to_next) + operand(level, x, node + 2u * to_next);
  }
  return sum;
}

fn bending_product(level : Level, x : u32, i : u32, j : u32, node : u32) -> vec3f {
  var sum = vec3f(0.0);
  if (level.bending_i > 0.0) {
    sum += level.bending_i * select(1.0, level.rim, on_rim(j, level.ny)) *
           line_bending(level, x, i, level.bend_end_i, node, 1u);
  }
  if (level.bending_j > 0.0) {
    sum += level.bending_j * select(1.0, level.rim, on_rim(i, level.nx)) *
           line_bending(level, x, j, level.bend_end_j, node, level.nx);
  }
  return sum;
}
