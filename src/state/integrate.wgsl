// One substep of one node, whatever moves it: its motion, a hand, or forces.
// Source: docs/solvers/mass_spring.md, equations 3 to 5. The including kernel binds `step`, `rest` and `motions`.
#include "state/grab.wgsl"
#include "state/node_state.wgsl"
#include "state/step.wgsl"
#include "state/wind.wgsl"

// Semi-implicit Euler: v += dt (a + f/m - drag (v - w)), then x += dt v.
fn integrate_free(before : NodeState, force : vec3f) -> NodeState {
  let inverse_mass = before.position.w;
  let v = before.velocity.xyz;
  let slip = v - wind_at(before.position.xyz);  // against the air; without wind exactly v
  let acceleration = step.air.acceleration.xyz + inverse_mass * force - step.air.drag * slip;
  let velocity = v + step.time.dt * acceleration;
  return NodeState(vec4f(before.position.xyz + step.time.dt * velocity, inverse_mass), vec4f(velocity, 0.0));
}

// A node that is pinned or moved. rest[node].w is its motion (Model::motion); the rows of `motions` are x, y and z
// of R·rest + t at the end of the substep.
fn integrate_kinematic(node : u32, before : NodeState) -> NodeState {
  let motion = u32(rest[node].w);
  if (motion < 2u) { return NodeState(before.position, vec4f(0.0)); }  // pinned
  let row = step.nodes.first_motion + 3u * (motion - 2u);
  let place = vec4f(rest[node].xyz, 1.0);
  let position = vec3f(dot(place, motions[row]), dot(place, motions[row + 1u]), dot(place, motions[row + 2u]));
  return NodeState(vec4f(position, 0.0), vec4f((position - before.position.xyz) / step.time.dt, 0.0));
}

// Whether forces do not move the node: it is pinned, moved or grabbed.
fn is_prescribed(node : u32, before : NodeState) -> bool { return before.position.w == 0.0 || is_grabbed(node); }

fn integrate_prescribed(node : u32, before : NodeState) -> NodeState {
  if (before.position.w == 0.0) { return integrate_kinematic(node, before); }
  return integrate_grabbed(node, before);
}

fn integrate_node(node : u32, before : NodeState, force : vec3f) -> NodeState {
  if (is_prescribed(node, before)) { return integrate_prescribed(node, before); }
  return integrate_free(before, force);
}
