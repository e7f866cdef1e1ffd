// The smoothing sweeps of a V-cycle on one level of a grid or a mesh, for one node each. The including file binds
// `vectors` and defines Level and its matrix: the product A x, product(level, x, node), x as that product takes it,
// operand(level, x, node), and what stores an entry of it, keep_vector(level, x, node, value). x is the number of one
// of the level's vectors. Source: docs/solvers/multigrid.md, equation 8.
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/solve.wgsl"

// r - A x
fn left_of(level : Level, x : u32, node : u32) -> vec3f {
  return vectors[vector_at(level, kResidual, node)].xyz - product(level, x, node);
}

// What x changes by, keep d + take D⁻¹ (r - A x), with d from a vector.
fn sweep_of(level : Level, step : u32, x : u32, keep : f32, take : f32, node : u32) -> vec3f {
  let d = vectors[vector_at(level, step, node)].xyz;
  return keep * d + take * times(inverse_at(level, node), left_of(level, x, node));
}

// The first smoothing sweep: it leaves d for the next.
fn begin_smoothing(level : Level, from_x : u32, to_x : u32, node : u32) {
  let d = kBegin * times(inverse_at(level, node), left_of(level, from_x, node));
  keep_vector(level, to_x, node, operand(level, from_x, node) + d);
  vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
}

// The last sweep.
fn end_smoothing(level : Level, from_x : u32, to_x : u32, node : u32) {
  let d = sweep_of(level, kDirection, from_x, kKeep, kTake, node);
  keep_vector(level, to_x, node, operand(level, from_x, node) + d);
}

// The residual after smoothing, the right-hand side of the next level.
fn keep_residual(level : Level, node : u32) {
  keep_vector(level, kDirection, node, left_of(level, kFirst, node));
}
