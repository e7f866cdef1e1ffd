// Quadratic bending of a level: k/2 |x(m-1) - 2 x(m) + x(m+1)|² about the inner nodes m of each row and column. The
// including file has the field that it is applied to, operand(level, x, node).
#include "method/multigrid/grid_level.wgsl"

fn line_bending(level : Level, x : u32, at : u32, side : u32, last_bend : f32, node : u32, to_next : u32) -> vec3f {
  let own = operand(level, x, node);
  var sum = vec3f(0.0);
  let before = bend_ratio(max(at, 1u) - 1u, side, last_bend);
  if (before > 0.0) {
    sum += before * (operand(level, x, node - 2u * to_next) - (1.0 + before) * operand(level, x, node - to_next) +
                     before * own);
  }
  let about = bend_ratio(at, side, last_bend);
  if (about > 0.0) {
    sum -= (1.0 + about) * (operand(level, x, node - to_next) - (1.0 + about) * own +
                            about * operand(level, x, node + to_next));
  }
  let behind = bend_ratio(at + 1u, side, last_bend);
  if (behind > 0.0) {
    sum += own - (1.0 + behind) * operand(level, x, node + to_next) +
           behind * operand(level, x, node + 2u * to_next);
  }
  return sum;
}

fn bending_product(level : Level, x : u32, i : u32, j : u32, node : u32) -> vec3f {
  var sum = vec3f(0.0);
  if (level.bending_i > 0.0) {
    sum += level.bending_i * select(1.0, level.rim, on_rim(j, level.ny)) *
           line_bending(level, x, i, level.nx, level.last_bend_i, node, 1u);
  }
  if (level.bending_j > 0.0) {
    sum += level.bending_j * select(1.0, level.rim, on_rim(i, level.nx)) *
           line_bending(level, x, j, level.ny, level.last_bend_j, node, level.nx);
  }
  return sum;
}
