// Semi-implicit Euler for one node: v += dt (a + f/m - drag (v - w)), then x += dt v. Kinematic nodes follow their
// motion. Source: docs/solvers/mass_spring.md, equations 3 to 5. The including kernel binds `step` and `motions`.
#include "state/grab.wgsl"
#include "state/node_state.wgsl"
#include "state/step.wgsl"
#include "state/wind.wgsl"

fn integrate_free(before : NodeState, force : vec3f) -> NodeState {
  let inverse_mass = before.position.w;
  let v = before.velocity.xyz;
  let slip = v - wind_at(before.position.xyz);  // against the air; where no wind blows, v to the bit
  let acceleration = step.acceleration.xyz + inverse_mass * force - step.drag * slip;
  let velocity = v + step.dt * acceleration;
  return NodeState(vec4f(before.position.xyz + step.dt * velocity, inverse_mass), vec4f(velocity, 0.0));
}

// A kinematic node: `place` is its rest position and, in w, its motion (HostModel::motion). The rows of
// `motions` are x, y and z of R·rest + t at the end of the substep.
fn integrate_held(before : NodeState, place : vec4f) -> NodeState {
  let motion = u32(place.w);
  if (motion < 2u) { return NodeState(before.position, vec4f(0.0)); }  // pinned
  let row = step.first_motion + 3u * (motion - 2u);
  let rest = vec4f(place.xyz, 1.0);
  let position = vec3f(dot(rest, motions[row]), dot(rest, motions[row + 1u]), dot(rest, motions[row + 2u]));
  return NodeState(vec4f(position, 0.0), vec4f((position - before.position.xyz) / step.dt, 0.0));
}
