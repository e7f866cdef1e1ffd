// The force on node a of a spring from a to b: Hooke's law and damping along the spring.
// Source: Sung et al., Algorithm 1; docs/solvers/mass_spring.md, equation 1.
const kMinLength = 1e-9;  // m; a shorter spring has no direction, and pulls nowhere

struct SpringState {
  direction : vec3f,  // unit, from a to b; 0 where the spring is too short to have one
  tension : f32,      // N; positive pulls the nodes together
}

fn spring_state(span : vec3f, velocity_difference : vec3f, rest_length : f32, stiffness : f32, damping : f32) -> SpringState {
  let len = length(span);
  if (len < kMinLength) { return SpringState(vec3f(0.0), 0.0); }
  let direction = span / len;
  let stretch_rate = dot(velocity_difference, direction);  // m/s
  return SpringState(direction, stiffness * (len - rest_length) + damping * stretch_rate);
}
