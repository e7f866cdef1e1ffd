// The parts of the V-cycle on coarse levels, for one node each. The including kernel binds `vectors` and `operators`, and has the solution
// that a step goes on from, operand(level, node). Source: docs/solvers/multigrid.md, equation 8.
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/coarse_operator.wgsl"

// r - A x
fn left_of(level : Level, node : u32) -> vec3f {
  let j = node / level.nx;
  return vectors[vector_at(level, kResidual, node)].xyz - coarse_product(level, node - j * level.nx, j, node);
}

// x += keep d + take D⁻¹ (r - A x)
fn smooth_node(level : Level, to_x : u32, keep : f32, take : f32, node : u32) {
  let d = keep * vectors[vector_at(level, kDirection, node)].xyz + take * times(inverse_at(level, node), left_of(level, node));
  vectors[vector_at(level, to_x, node)] = vec4f(operand(level, node) + d, 0.0);
}

fn residual_node(level : Level, node : u32) {
  vectors[vector_at(level, kDirection, node)] = vec4f(left_of(level, node), 0.0);
}

// The first step of smoothing from there.
fn prolong_node(level : Level, node : u32) {
  let d = kBegin * times(inverse_at(level, node), left_of(level, node));
  vectors[vector_at(level, kSecond, node)] = vec4f(operand(level, node) + d, 0.0);
  vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
}
