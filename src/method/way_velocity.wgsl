// The velocity of a node's way in a substep without its elements: along its motion, to the hand, or by inertia, gravity
// and air. The including kernel binds `step`, `position_in`, `rest`, `motions` and `corners`.
// Source: docs/solvers/xpbd.md and docs/solvers/vbd.md, equation 1.
#include "method/air_step.wgsl"
#include "state/integrate.wgsl"
override kAirPushes : bool = false;  // false: `corners` is not read

fn way_velocity(node : u32, before : NodeState) -> vec3f {
  let velocity = integrate_node(node, before, vec3f(0.0)).velocity.xyz;
  if (kAirPushes && !is_prescribed(node, before)) { return velocity_in_air(node, before, velocity); }
  return velocity;
}
