// Smoothing and its residual on a level of a mesh, for one node each. The including kernel binds `vectors`, `blocks`, `row_starts` and
// `rows`. Source: docs/solvers/multigrid.md, equation 8.
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/mesh_block.wgsl"

// r - A x, with x one of the level's vectors.
fn left_of(level : Level, x : u32, node : u32) -> vec3f {
  let first = vector_at(level, x, 0u);
  var sum = times(block_of(level, node), vectors[first + node].xyz);
  let list = level.first_row + node;
  for (var k = row_starts[list]; k < row_starts[list + 1u]; k++) {
    let coupling = rows[k];
    sum += times(block_of(level, coupling.block), vectors[first + coupling.node].xyz);
  }
  return vectors[vector_at(level, kResidual, node)].xyz - sum;
}

// What x changes by, keep d + take D⁻¹ (r - A x).
fn step_of(level : Level, x : u32, keep : f32, take : f32, node : u32) -> vec3f {
  let d = vectors[vector_at(level, kDirection, node)].xyz;
  return keep * d + take * times(inverse_at(level, node), left_of(level, x, node));
}

// The first step of smoothing: it leaves d for the second.
fn begin_smoothing(level : Level, from_x : u32, to_x : u32, node : u32) {
  let d = step_of(level, from_x, 0.0, kBegin, node);
  vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
  vectors[vector_at(level, to_x, node)] = vec4f(vectors[vector_at(level, from_x, node)].xyz + d, 0.0);
}

// The second step.
fn end_smoothing(level : Level, from_x : u32, to_x : u32, node : u32) {
  let d = step_of(level, from_x, kKeep, kTake, node);
  vectors[vector_at(level, to_x, node)] = vec4f(vectors[vector_at(level, from_x, node)].xyz + d, 0.0);
}

fn keep_residual(level : Level, node : u32) {
  vectors[vector_at(level, kDirection, node)] = vec4f(left_of(level, kFirst, node), 0.0);
}
