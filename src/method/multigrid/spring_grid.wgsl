// The springs of a grid. The including kernel binds `step`.
#include "method/multigrid/spring_block.wgsl"
struct SpringGrid {  // mirror: src/method/multigrid/level.hpp
  first_vertex : u32,
  nx : u32,
  ny : u32,
  uniform_weights : u32,  // 1: springs along the boundary count in full
  stiffness : vec4f,      // N/m: structural, shear, bend
  rest_length : vec4f,    // m: structural along i, along j, shear
  damping : f32,          // N·s/m
}

// Part of a spring's stiffness where it runs along a boundary line, which has cloth on one side only.
fn line_weight(grid : SpringGrid, at : u32, side : u32) -> f32 {
  return select(1.0, 0.5, grid.uniform_weights == 0u && (at == 0u || at + 1u == side));
}
