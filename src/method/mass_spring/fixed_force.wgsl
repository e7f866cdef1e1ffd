// The force of a spring in fixed point, as Algorithm 1 of Sung et al. sums it. The including kernel binds `step`.
#include "element/spring/law.wgsl"
#include "state/step.wgsl"

// Rounded once, so that the two nodes' forces cancel exactly.
fn fixed_force(span : vec3f, rate : vec3f, rest_length : f32, stiffness : f32, damping : f32) -> vec3i {
  let spring = spring_state(span, rate, rest_length, stiffness, damping);
  let tension = clamp(spring.tension, -step.method.force_limit, step.method.force_limit);
  return vec3i(round((step.method.force_scale * tension * spring.per_length) * span));
}
