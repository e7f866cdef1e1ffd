// What inertia, air and gravity have in the equation of a free node. The including kernel binds `step`.
// Source: docs/solvers/multigrid.md, equations 1 to 6.
#include "state/node_state.wgsl"
#include "state/wind.wgsl"
#include "method/multigrid/spring.wgsl"

// What they leave of it, N, where the node has come with a velocity.
fn inertia_residual(now : NodeState, velocity_before : vec3f, velocity : vec3f, formula : Formula) -> vec3f {
  let v = now.velocity.xyz;
  let base_velocity = v + formula.c * (v - velocity_before);
  let pull_of_field = step.air.acceleration.xyz + step.air.drag * (wind_at(now.position.xyz) - velocity);
  return (1.0 / now.position.w) * ((base_velocity - velocity) / formula.he + pull_of_field);
}

// On the matrix's diagonal, N/m.
fn inertia_stiffness(now : NodeState, formula : Formula) -> f32 {
  return (1.0 / now.position.w) * (1.0 / formula.he + step.air.drag) / formula.he;
}
