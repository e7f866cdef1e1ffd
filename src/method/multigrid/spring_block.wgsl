// What a substep's formula makes of its length, and of a spring. The including kernel binds `step`.
#include "state/step.wgsl"
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
