// The parts of the V-cycle on coarse levels, for one node each. The including kernel binds `vectors` and `operators`. Source:
// docs/solvers/multigrid.md, equations 7 and 8.
#include "multigrid/chebyshev.wgsl"
#include "multigrid/coarse_operator.wgsl"
#include "multigrid/correction.wgsl"
#include "multigrid/restriction.wgsl"
var<private> operand_vector : u32;  // which vector A is applied to
var<private> coarser : Level;       // whose correction is added to it; nx 0: none

fn operand(level : Level, node : u32) -> vec3f {
  let x = vectors[vector_at(level, operand_vector, node)].xyz;
  if (coarser.nx == 0u) { return x; }
  let j = node / level.nx;
  return x + correction(level, coarser, node - j * level.nx, j);
}

// r - A x, with x one of the level's vectors and, where `next` is there, the correction of that level.
fn left_of(level : Level, x : u32, next : Level, node : u32) -> vec3f {
  operand_vector = x;
  coarser = next;
  let j = node / level.nx;
  return vectors[vector_at(level, kResidual, node)].xyz - coarse_product(level, node - j * level.nx, j, node);
}

fn no_level() -> Level { return Level(0u, 0u, 0u, 0u, 0.0, 0.0, 0u, 0u, 0.0, 0u, 0u, 0u); }

// x += keep d + take D⁻¹ (r - A x), from one vector to another.
fn smooth_node(level : Level, from_x : u32, to_x : u32, keep : f32, take : f32, node : u32) {
  let left = left_of(level, from_x, no_level(), node);
  let d = keep * vectors[vector_at(level, kDirection, node)].xyz + take * times(inverse_at(level, node), left);
  vectors[vector_at(level, to_x, node)] = vec4f(operand(level, node) + d, 0.0);
}

fn residual_node(level : Level, node : u32) {
  vectors[vector_at(level, kDirection, node)] = vec4f(left_of(level, kFirst, no_level(), node), 0.0);
}

fn prolong_node(level : Level, next : Level, node : u32) {
  let d = kBegin * times(inverse_at(level, node), left_of(level, kFirst, next, node));
  vectors[vector_at(level, kSecond, node)] = vec4f(operand(level, node) + d, 0.0);
  vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
}
