// What quadratic bending adds to the diagonal of a level: bending.wgsl.
#include "method/multigrid/level.wgsl"

// The squares of what a node counts in the second differences of its line.
fn line_squares(at : u32, end : u32) -> f32 {
  return select(0.0, 1.0, at > 1u && at <= end) + select(0.0, 4.0, at > 0u && at < end) + select(0.0, 1.0, at + 1u < end);
}

fn on_rim(at : u32, side : u32) -> bool { return at == 0u || at + 1u == side; }

fn bending_diagonal(level : Level, i : u32, j : u32) -> f32 {
  return level.bending_i * select(1.0, level.rim, on_rim(j, level.ny)) * line_squares(i, level.bend_end_i) +
         level.bending_j * select(1.0, level.rim, on_rim(i, level.nx)) * line_squares(j, level.bend_end_j);
}
