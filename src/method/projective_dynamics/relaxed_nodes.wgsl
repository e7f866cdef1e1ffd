// The nodes of one cloth, and what their global system is relaxed by. The including kernel binds `step` and `cloth`.
// Source: docs/solvers/projective_dynamics.md, equations 4 and 6.
struct RelaxedNodes {  // mirror: src/method/projective_dynamics/relaxed_cloth.hpp
  first_node : u32,
  count : u32,
  stiffness_rate : f32,  // 1/s²
  damping_rate : f32,    // 1/s
  radius : f32,
}

/// How much of what is left a Jacobi step takes.
fn gain() -> f32 {
  let dt = step.time.dt;
  return (1.0 + cloth.radius) / (1.0 + dt * (dt * cloth.stiffness_rate + cloth.damping_rate));
}
