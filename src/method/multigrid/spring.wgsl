// The coefficients of a substep's formula, and a spring's terms: equations 1, 5 and 6 of docs/solvers/multigrid.md. The
// including kernel binds `step`.
#include "element/spring/law.wgsl"
#include "method/multigrid/lead.wgsl"
#include "state/step.wgsl"

// BDF2 with a step that is `step_ratio` of the one before it: x' = x + c (x - x before) + he v'. Ratio 0: backward
// Euler.
struct Formula { he : f32, c : f32 }
fn formula_of(ratio : f32) -> Formula {
  return Formula(step.time.dt * (1.0 + ratio) / (1.0 + 2.0 * ratio), ratio * ratio / (1.0 + 2.0 * ratio));
}

// A spring's rest length, m, and stiffness, N/m; beyond `longest`, m, if that is not 0, there is `more` of it: equation
// (5a).
struct SpringLaw { rest_length : f32, stiffness : f32, longest : f32, more : f32 }
override kLimits : bool = true;  // false: no spring has such a length
const kStiffer = 50.0;  // mirror: src/element/spring/law.hpp
fn law_of(rest_length : f32, longest : f32, stiffness : f32) -> SpringLaw {
  return SpringLaw(rest_length, stiffness, longest, kStiffer * stiffness);
}
// k (l - l0) + m (l - L) = (k + m) (l - (k l0 + m L)/(k + m)): of such a length it is another spring.
struct LawAtLength { rest_length : f32, stiffness : f32 }
fn law_at(law : SpringLaw, len : f32) -> LawAtLength {
  if (!kLimits) { return LawAtLength(law.rest_length, law.stiffness); }
  let beyond = law.longest > 0.0 && len > law.longest;
  let stiffness = law.stiffness + law.more;
  let rest_length = (law.stiffness * law.rest_length + law.more * law.longest) / stiffness;
  return LawAtLength(select(law.rest_length, rest_length, beyond), select(law.stiffness, stiffness, beyond));
}

// How a spring's force changes: k [(1 - b) n nᵀ + b I] + c/he n nᵀ with b = max(0, 1 - l0 / l): its Hessian where it is
// stretched, and where it is pressed without what would make it indefinite.
struct SpringBlock {
  direction : vec3f,
  along : f32,   // N/m
  across : f32,  // N/m
}
fn spring_block(span : vec3f, law : SpringLaw, damping : f32) -> SpringBlock {
  let len = length(span);
  if (len < kMinLength) { return SpringBlock(vec3f(0.0), 0.0, 0.0); }
  let now = law_at(law, len);
  let b = max(0.0, 1.0 - now.rest_length / len);
  return SpringBlock(span / len, now.stiffness * (1.0 - b) + damping, now.stiffness * b);
}
fn block_times(hessian : SpringBlock, v : vec3f) -> vec3f {
  return hessian.along * dot(hessian.direction, v) * hessian.direction + hessian.across * v;
}

// A spring's terms at a node.
struct Pull {
  force : vec3f,        // N: on the node, where both have come to place + start
  block : SpringBlock,  // N/m: its part of the matrix
}

// From the node to its neighbour: span, m; how much it changes by the start of the unknown, m; and by the velocity that
// this would be, m/s.
fn pull_of(span : vec3f, span_step : vec3f, rate_of_span : vec3f, law : SpringLaw, damping : f32, rate : f32) -> Pull {
  let lead = lead_of(dot(span_step, span_step) / max(dot(span, span), kMinLength * kMinLength));
  let at = span + lead * span_step;
  let hessian = spring_block(at, law, 0.0);
  let now = law_at(law, length(at));
  let tension = now.stiffness * (length(at) - now.rest_length);
  var force = tension * hessian.direction + block_times(hessian, (1.0 - lead) * span_step);
  if (damping > 0.0) {
    let later = span + damping_lead(lead) * span_step;
    let square = max(dot(later, later), kMinLength * kMinLength);
    force += (damping * dot(later, rate_of_span) / square) * later;
  }
  return Pull(force, SpringBlock(hessian.direction, hessian.along + damping * rate, hessian.across));
}
