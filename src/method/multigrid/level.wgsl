// A level of a cloth's hierarchy, and its place in the buffers `vectors` and `operators`. Source: docs/solvers/multigrid.md.
#include "method/multigrid/vectors.wgsl"
struct Level {  // mirror: src/method/multigrid/level.hpp
  nx : u32,
  ny : u32,              // nodes; 0: there is no such level
  first_vector : u32,    // in `vectors`, in vec4f
  first_operator : u32,  // in `operators`, in vec2f
  bending_i : f32,       // N/m: resistance to second differences along i
  bending_j : f32,
  bend_end_i : u32,      // they are taken about nodes 1 to this, exclusive
  bend_end_j : u32,
  rim : f32,             // part of the bending that lines along the boundary have
  padding_a : u32,
  padding_b : u32,
  padding_c : u32,
}
// A kernel's uniform `levels` has the level that it works on, and the next coarser one.

fn vector_at(level : Level, vector : u32, node : u32) -> u32 { return level.first_vector + vector * (level.nx * level.ny) + node; }
fn operator_at(level : Level, part : u32, node : u32) -> u32 { return level.first_operator + part * (level.nx * level.ny) + node; }
