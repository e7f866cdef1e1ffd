// A grabbed node is a follower: it goes to its target at a rate, no faster than the grabs' speed, and the forces do not
// reach it. Its inverse mass stays, so contact still pushes it and a release needs nothing. The including kernel binds
// `step`, `rest` and `motions`; nodes outside of the range that has all grabbed ones read neither.
// Source: docs/solvers/mass_spring.md, equation 10.
#include "state/node_state.wgsl"
#include "state/step.wgsl"

// Where a node is pulled, xyz in m; w: 0 where nothing pulls it in this substep.
fn grab_goal(node : u32) -> vec4f {
  if (node - step.hands.first >= step.hands.count) { return vec4f(0.0); }  // below the first, it wraps
  let word = rest[node].w;
  if (word >= 0.0) { return vec4f(0.0); }
  let slot = u32(-1.0 - word);
  return motions[slot + select(step.hands.first_moving, step.hands.first_still, slot < step.hands.still)];
}

fn is_grabbed(node : u32) -> bool { return grab_goal(node).w != 0.0; }

fn integrate_grabbed(node : u32, before : NodeState) -> NodeState {
  let goal = grab_goal(node).xyz;
  var velocity = step.hands.rate * (goal - before.position.xyz);
  let speed = length(velocity);
  if (speed > step.hands.speed) { velocity = (step.hands.speed / speed) * velocity; }
  return NodeState(vec4f(before.position.xyz + step.time.dt * velocity, before.position.w), vec4f(velocity, 0.0));
}
