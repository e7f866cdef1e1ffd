// A level of a grid's hierarchy, and its place in the buffers `vectors` and `operators`. Source:
// docs/solvers/multigrid.md.
#include "method/multigrid/cloth.wgsl"
struct GridLevelParams {  // mirror: src/method/multigrid/grid_level_params.hpp
  nx : u32,
  ny : u32,              // nodes; 0: there is no such level
  first_vector : u32,    // in `vectors`, in vec4f
  first_operator : u32,  // in `operators`, in vec2f
  bending_i : f32,       // N/m: resistance to second differences along i
  bending_j : f32,
  last_bend_i : f32,     // an interval by the last one, which may be shorter
  last_bend_j : f32,
  rim : f32,             // part of the bending that lines along the boundary have
  vectors : u32,         // of a cloth, all levels, in vec4f
  operators : u32,       // the same in vec2f
  padding : u32,
}
// The level type of the files that grids and meshes share. A kernel's uniform `levels` has the level that it works
// on, and the next coarser one.
alias Level = GridLevelParams;

fn node_count(level : Level) -> u32 { return level.nx * level.ny; }
fn vector_at(level : Level, vector : u32, node : u32) -> u32 {
  return cloth * level.vectors + level.first_vector + vector * (level.nx * level.ny) + node;
}
fn operator_at(level : Level, part : u32, node : u32) -> u32 {
  return cloth * level.operators + level.first_operator + part * (level.nx * level.ny) + node;
}
// Of the finest level: a node among those of all cloths.
fn among_all(level : Level, node : u32) -> u32 { return cloth * (level.nx * level.ny) + node; }

// The second difference about node `at` of a line of `side` nodes is x(at-1) - (1 + r) x(at) + r x(at+1), r = 1 but for
// the last one, where the intervals may differ. 0 where there is none.
fn bend_ratio(at : u32, side : u32, last_bend : f32) -> f32 {
  return select(0.0, select(1.0, last_bend, at + 2u == side), at > 0u && at + 1u < side);
}

// The squared coefficients of a node in the second differences of its line.
fn line_squares(at : u32, side : u32, last_bend : f32) -> f32 {
  let own = bend_ratio(at, side, last_bend);
  let before = bend_ratio(max(at, 1u) - 1u, side, last_bend);
  return before * before + select(0.0, (1.0 + own) * (1.0 + own), own > 0.0) +
         select(0.0, 1.0, bend_ratio(at + 1u, side, last_bend) > 0.0);
}

fn on_rim(at : u32, side : u32) -> bool { return at == 0u || at + 1u == side; }

// The part of quadratic bending (bending.wgsl) in the diagonal.
fn bending_diagonal(level : Level, i : u32, j : u32) -> f32 {
  return level.bending_i * select(1.0, level.rim, on_rim(j, level.ny)) * line_squares(i, level.nx, level.last_bend_i) +
         level.bending_j * select(1.0, level.rim, on_rim(i, level.nx)) * line_squares(j, level.ny, level.last_bend_j);
}
