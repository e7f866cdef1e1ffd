// The force on node a of a spring from a to b is tension * per_length * span: Hooke's law and damping along the spring.
// Source: Sung et al., Algorithm 1; docs/solvers/mass_spring.md, equation 1. One root and one division per spring; a
// unit direction would take three divisions.
const kMinLength = 1e-9;  // m; a shorter spring has no direction, and pulls nowhere

struct SpringState {
  tension : f32,     // N; positive pulls the nodes together
  per_length : f32,  // 1/m; 0 where the spring is too short to have a direction
}

fn spring_state(span : vec3f, velocity_difference : vec3f, rest_length : f32, stiffness : f32,
                damping : f32) -> SpringState {
  let len = sqrt(dot(span, span));
  let per_length = select(1.0 / max(len, kMinLength), 0.0, len < kMinLength);
  let stretch_rate = dot(velocity_difference, span) * per_length;  // m/s
  return SpringState(stiffness * (len - rest_length) + damping * stretch_rate, per_length);
}
