// The springs of a grid: which there are, and how stiff, follows from a node's place.
struct SpringGrid {  // mirror: src/element/spring/spring_grid.hpp
  first_vertex : u32,
  nx : u32,
  ny : u32,
  uniform_weights : u32,  // 1: springs along the boundary count in full
  stiffness : vec4f,      // N/m: structural, shear, bend
  damping : vec4f,        // N·s/m: the same; 0 where the stiffness is 0
  rest_length : vec4f,    // m: structural along i, along j, shear
  bending : vec2f,        // N/m: of second differences along i, along j
  longest : vec2f,        // m: beyond which structural ones are stiffer, along i, along j; 0: none
}

// Part of the stiffness along line `at` of `side` lines: a boundary spring has cloth on one side only.
fn line_weight(grid : SpringGrid, at : u32, side : u32) -> f32 {
  return select(0.5, 1.0, grid.uniform_weights == 1u || (at > 0u && at + 1u < side));
}

override kBend : bool = true;  // false: there are no bend springs
// The springs from a node to ones behind it, row by row.
const kRight = 0u;
const kDown = 1u;
const kDownRight = 2u;
const kDownLeft = 3u;
const kFarRight = 4u;
const kFarDown = 5u;
