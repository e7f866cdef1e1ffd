// Semi-implicit Euler for one node: v += dt (a + f/m - drag v), then x += dt v. Kinematic nodes follow their motion.
// Source: docs/solvers/mass_spring.md, equations 3 to 5.
#include "shared/step.wgsl"
struct NodeState {
  position : vec4f,  // m; w: inverse mass, 1/kg
  velocity : vec4f,  // m/s
}

fn integrate_free(params : StepParams, before : NodeState, force : vec3f) -> NodeState {
  let inverse_mass = before.position.w;
  let v = before.velocity.xyz;
  let acceleration = params.acceleration.xyz + inverse_mass * force - params.drag * v;
  let velocity = v + params.dt * acceleration;
  return NodeState(vec4f(before.position.xyz + params.dt * velocity, inverse_mass), vec4f(velocity, 0.0));
}

// A node that is moved: `rows` are x, y and z of R·rest + t at the end of the substep.
fn integrate_moved(params : StepParams, before : NodeState, rest : vec3f, rows : mat3x4f) -> NodeState {
  let position = vec4f(rest, 1.0) * rows;
  return NodeState(vec4f(position, 0.0), vec4f((position - before.position.xyz) / params.dt, 0.0));
}
