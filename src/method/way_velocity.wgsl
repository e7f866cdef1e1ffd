// The velocity of a node's way in a substep without its elements: along its motion, to the hand, or by inertia,
// gravity, gas and air. The including kernel binds `step`, `position_in`, `rest`, `motions` and `corners`.
// Source: docs/solvers/xpbd.md and docs/solvers/vbd.md, equation 1.
#include "method/air_step.wgsl"
#include "state/integrate.wgsl"
override kAirPushes : bool = false;  // false: `corners` is not read
override kGasPushes : bool = false;  // false: way[node] has no force yet

// What drag, as of the end of the substep, leaves of an acceleration and of a mobility.
fn left_by_drag() -> f32 { return 1.0 / (1.0 + step.time.dt * step.air.drag); }

// `begun`: way[node] as it comes.
fn way_velocity(node : u32, before : NodeState, begun : vec4f) -> vec3f {
  let force = select(vec3f(0.0), begun.xyz, kGasPushes);
  var velocity = integrate_node(node, before, force).velocity.xyz;
  if (is_prescribed(node, before)) { return velocity; }
  if (step.air.drag > 0.0) {
    velocity = before.velocity.xyz + left_by_drag() * (velocity - before.velocity.xyz);
  }
  if (kAirPushes) { return velocity_in_air(node, before, velocity); }
  return velocity;
}

// What the node's elements move it by, 1/kg; 0: they do not.
fn way_mobility(node : u32, before : NodeState) -> f32 {
  return select(left_by_drag() * before.position.w, 0.0, is_prescribed(node, before));
}
