// Quadratic bending of a level: k/2 |x(m-1) - 2 x(m) + x(m+1)|² about the nodes m of each row and column. The including file has the field
// that it is applied to, operand(level, node).
#include "method/multigrid/bending_diagonal.wgsl"

fn line_bending(level : Level, at : u32, end : u32, node : u32, step_to_next : u32) -> vec3f {
  let x = operand(level, node);
  var sum = vec3f(0.0);
  if (at > 1u && at <= end) { sum += operand(level, node - 2u * step_to_next) - 2.0 * operand(level, node - step_to_next) + x; }
  if (at > 0u && at < end) { sum -= 2.0 * (operand(level, node - step_to_next) - 2.0 * x + operand(level, node + step_to_next)); }
  if (at + 1u < end) { sum += x - 2.0 * operand(level, node + step_to_next) + operand(level, node + 2u * step_to_next); }
  return sum;
}

// Where nothing bends there are no second differences: lines end at 0.
fn bending_product(level : Level, i : u32, j : u32, node : u32) -> vec3f {
  let end_i = select(0u, level.bend_end_i, level.bending_i > 0.0);
  let end_j = select(0u, level.bend_end_j, level.bending_j > 0.0);
  return level.bending_i * select(1.0, level.rim, on_rim(j, level.ny)) * line_bending(level, i, end_i, node, 1u) +
         level.bending_j * select(1.0, level.rim, on_rim(i, level.nx)) * line_bending(level, j, end_j, node, level.nx);
}
