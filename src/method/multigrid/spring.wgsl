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
  return SpringLaw(rest_length, stiffness, select(0.0, longest, stiffness > 0.0), kStiffer * stiffness);
}
fn is_long(law : SpringLaw, len : f32) -> bool { return kLimits && law.longest > 0.0 && len > law.longest; }
// k (l - l0) + m (l - L) = (k + m) (l - (k l0 + m L)/(k + m)): of such a length it is another spring.
struct LawAtLength { rest_length : f32, stiffness : f32 }
fn law_at(law : SpringLaw, len : f32) -> LawAtLength {
  if (!kLimits) { return LawAtLength(law.rest_length, law.stiffness); }
  let beyond = is_long(law, len);
  let stiffness = law.stiffness + law.more;
  let rest_length = (law.stiffness * law.rest_length + law.more * law.longest) / stiffness;
  return LawAtLength(select(law.rest_length, rest_length, beyond), select(law.stiffness, stiffness, beyond));
}

// How a spring lies: all that its matrix depends on besides its law.
struct SpringPose {
  direction : vec3f,  // n; 0: too short to have one
  stretch : f32,      // b = max(0, 1 - l0 / l); with contact (6a)
  is_long : bool,     // whether it is longer than it should be: equation (5a)
}
// `most`: the length that decides whether it is long.
fn pose_of(span : vec3f, law : SpringLaw, most : f32) -> SpringPose {
  let len = length(span);
  if (len < kMinLength) { return SpringPose(vec3f(0.0), 0.0, false); }
  return SpringPose(span / len, max(0.0, 1.0 - law_at(law, most).rest_length / len), is_long(law, most));
}

// How a spring's force changes: k [(1 - b) n nᵀ + b I] + c/he n nᵀ: its Hessian where it is stretched, and where it is
// pressed without what would make it indefinite.
struct SpringBlock {
  direction : vec3f,
  along : f32,   // N/m
  across : f32,  // N/m
}
fn spring_block(pose : SpringPose, law : SpringLaw, damping : f32) -> SpringBlock {
  let stiffness = select(law.stiffness, law.stiffness + law.more, pose.is_long);
  return SpringBlock(pose.direction, stiffness * (1.0 - pose.stretch) + damping, stiffness * pose.stretch);
}
fn block_times(hessian : SpringBlock, v : vec3f) -> vec3f {
  return hessian.along * dot(hessian.direction, v) * hessian.direction + hessian.across * v;
}

// b of the matrix with contact, equation (6a): what presses here, or where the unknown starts, resists across by the
// force that it has in the residual. `longer`: what the start of the unknown adds to its length, m.
fn held_across(pose : SpringPose, len : f32, rest_length : f32, longer : f32) -> SpringPose {
  let pressed = rest_length - len;  // m
  if (len < kMinLength || max(pressed, pressed - longer) <= 0.0) { return pose; }
  return SpringPose(pose.direction, min(1.0, abs(pressed - longer) / len), pose.is_long);
}

// A spring's terms at a node.
struct Pull {
  force : vec3f,        // N: on the node, where both have come to place + start
  pose : SpringPose,    // in which it is linearised
  block : SpringBlock,  // N/m: its part of the matrix
}

// From the node to its neighbour: span, m; how much it changes by the start of the unknown, m; and by the velocity that
// this would be, m/s.
fn pull_of(span : vec3f, span_step : vec3f, rate_of_span : vec3f, law : SpringLaw, damping : f32, rate : f32) -> Pull {
  let lead = lead_of(dot(span_step, span_step) / max(dot(span, span), kMinLength * kMinLength));
  let at = span + lead * span_step;
  let most = max(length(span), length(at));  // long in either, it is: docs/solvers/multigrid.md, Elements ahead
  let pose = pose_of(at, law, most);
  let hessian = spring_block(pose, law, 0.0);
  let now = law_at(law, most);
  let tension = now.stiffness * (length(at) - now.rest_length);
  var force = tension * hessian.direction + block_times(hessian, (1.0 - lead) * span_step);
  if (damping > 0.0) {
    let later = span + damping_lead(lead) * span_step;
    let square = max(dot(later, later), kMinLength * kMinLength);
    force += (damping * dot(later, rate_of_span) / square) * later;
  }
  if (kLeads) { return Pull(force, pose, spring_block(pose, law, damping * rate)); }
  let held = held_across(pose, length(at), now.rest_length, dot(pose.direction, span_step));
  return Pull(force, held, spring_block(held, law, damping * rate));
}
