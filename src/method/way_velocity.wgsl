// The velocity of a node's way in a substep without its elements: along its motion, to the hand, or by inertia,
// gravity, gas and air. The including kernel binds `step`, `position_in`, `rest`, `motions` and `corners`.
// Source: docs/solvers/xpbd.md and docs/solvers/vbd.md, equation 1.
#include "method/air_step.wgsl"
#include "state/integrate.wgsl"
override kAirPushes : bool = false;  // false: `corners` is not read
override kGasPushes : bool = false;  // false: way[node] has no force yet

// `begun`: way[node] as it comes.
fn way_velocity(node : u32, before : NodeState, begun : vec4f) -> vec3f {
  let force = select(vec3f(0.0), begun.xyz, kGasPushes);
  let velocity = integrate_node(node, before, force).velocity.xyz;
  if (kAirPushes && !is_prescribed(node, before)) { return velocity_in_air(node, before, velocity); }
  return velocity;
}
