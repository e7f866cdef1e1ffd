// The velocity that the air leaves a node of an explicit step, as one of backward Euler: equation 3 of docs/air.md. The
// including kernel also binds `position_in`.
#include "method/air.wgsl"
#include "state/node_state.wgsl"

fn corner_place(vertex : u32) -> vec3f { return position_in[vertex].xyz; }

// `before` is the node as the step begins, `velocity` what all other forces make of its velocity, m/s.
fn velocity_in_air(node : u32, before : NodeState, velocity : vec3f) -> vec3f {
  let wind = wind_at(before.position.xyz);
  let share = scaled(step.time.dt * before.position.w, air_at(node, wind - before.velocity.xyz));
  return velocity + times(inverse(sum_of(identity(1.0), share)), times(share, wind - velocity));
}
