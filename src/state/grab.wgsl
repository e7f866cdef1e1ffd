// A grabbed node is a follower: it goes to its target at a rate, no faster than the grab's speed, and the forces do not
// reach it. Its inverse mass stays, so contact still pushes it and a release needs nothing.
// Source: docs/solvers/mass_spring.md, equation 10.
#include "state/node_state.wgsl"
#include "state/step.wgsl"

fn is_grabbed(node : u32) -> bool { return any(step.hands.node == vec4u(node)); }

fn integrate_grabbed(node : u32, before : NodeState) -> NodeState {
  var goal = step.hands.goal[0].xyz;
  if (node == step.hands.node.y) { goal = step.hands.goal[1].xyz; }
  if (node == step.hands.node.z) { goal = step.hands.goal[2].xyz; }
  if (node == step.hands.node.w) { goal = step.hands.goal[3].xyz; }
  var velocity = step.hands.rate * (goal - before.position.xyz);
  let speed = length(velocity);
  if (speed > step.hands.speed) { velocity = (step.hands.speed / speed) * velocity; }
  return NodeState(vec4f(before.position.xyz + step.time.dt * velocity, before.position.w), vec4f(velocity, 0.0));
}
