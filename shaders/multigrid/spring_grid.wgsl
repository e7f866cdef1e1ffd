// The springs of a grid, and what a substep's formula makes of its length. The including kernel binds `step`.
#include "shared/step.wgsl"
struct SpringGrid {  // mirror: src/solver/multigrid/spring_grid.hpp
  first_vertex : u32,
  nx : u32,
  ny : u32,
  uniform_weights : u32,  // 1: springs along the boundary count in full
  stiffness : vec4f,      // N/m: structural, shear, bend
  rest_length : vec4f,    // m: structural along i, along j, shear
  damping : f32,          // N·s/m
}
const kShortest = 1e-9;   // m; a shorter spring has no direction, and pulls nowhere

// BDF2 with a step that is `step_ratio` of the one before it: x' = x + c (x - x before) + he v'. Ratio 0: backward Euler.
struct Formula { he : f32, c : f32 }
fn formula_of(ratio : f32) -> Formula {
  return Formula(step.dt * (1.0 + ratio) / (1.0 + 2.0 * ratio), ratio * ratio / (1.0 + 2.0 * ratio));
}

// How a spring's force changes: k [(1 - b) n nᵀ + b I] + c/he n nᵀ with b = max(0, 1 - l0 / l): its Hessian where it is stretched, and
// where it is pressed without what would make it indefinite.
struct SpringBlock {
  direction : vec3f,
  along : f32,   // N/m
  across : f32,  // N/m
}
fn spring_block(span : vec3f, rest_length : f32, stiffness : f32, damping : f32) -> SpringBlock {
  let len = length(span);
  if (len < kShortest) { return SpringBlock(vec3f(0.0), 0.0, 0.0); }
  let b = max(0.0, 1.0 - rest_length / len);
  return SpringBlock(span / len, stiffness * (1.0 - b) + damping, stiffness * b);
}
fn block_times(hessian : SpringBlock, v : vec3f) -> vec3f {
  return hessian.along * dot(hessian.direction, v) * hessian.direction + hessian.across * v;
}

// Part of a spring's stiffness where it runs along a boundary line, which has cloth on one side only.
fn line_weight(grid : SpringGrid, at : u32, side : u32) -> f32 {
  return select(1.0, 0.5, grid.uniform_weights == 0u && (at == 0u || at + 1u == side));
}
