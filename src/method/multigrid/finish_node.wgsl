// The end of a substep for one node: its new position and velocity. The including kernel binds `step`, `nodes`,
// `place`, `holds`, `position_in`, `velocity_in`, `position_out` and `velocity_out`. Source: docs/solvers/multigrid.md,
// equation 9.
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/hold.wgsl"
#include "method/multigrid/spring.wgsl"

fn finish_held(index : u32) {
  let node = nodes.first_vertex + index;
  let now = position_in[node];
  let held_at = place[index].xyz;
  position_out[node] = vec4f(held_at, now.w);
  velocity_out[node] = vec4f((held_at - now.xyz) / step.time.dt, 1.0);
}

fn finish_free(index : u32, solution : vec3f) {
  let node = nodes.first_vertex + index;
  let now = position_in[node];
  let velocity = velocity_in[node];
  let pressed = is_pressed(index);
  let formula = formula_of(select(step.time.step_ratio * velocity.w, 0.0, pressed));
  let way = step.time.dt * velocity.xyz + solution;
  let before = position_out[node].xyz;
  position_out[node] = vec4f(now.xyz + way, now.w);
  velocity_out[node] = vec4f((way - formula.c * (now.xyz - before)) / formula.he, select(1.0, 0.0, pressed));
}
