// Takes what obstacles press a node with in a substep, and clears its sums. The including kernel binds `presses`, and
// has what node_holds.wgsl needs, `aim` to read and write. Source: docs/solvers/vbd.md, Obstacles.
#include "contact/proximity/parting.wgsl"
#include "contact/proximity/pressed_vertex.wgsl"
#include "method/holds/node_holds.wgsl"
#include "state/contact.wgsl"

// How fast a node that comes to a surface goes back from it: contact/proximity/evaluate.wgsl, equation 3.
fn return_speed(velocity : vec3f, surface : vec3f, n : vec3f) -> f32 {
  let comes = -dot(n, velocity - surface);
  let e = step.contact.restitution;
  if (e == 0.0 || comes <= speed_of_load()) { return 0.0; }
  return max(0.0, e * comes + step.time.dt * dot(n, step.air.acceleration.xyz));
}

// Whether anything presses it in one direction. `velocity`: at the start of the substep.
fn take_hold(node : u32, velocity : vec3f) -> bool {
  let at = hold_at(node);
  aim[at + 2u] = vec4f(0.0, kFree, 0.0, 0.0);
  let pressed = pressed_vertex(node);
  if (pressed.weight == 0.0) { return false; }
  clear_presses(node);
  let size = length(pressed.normal);
  if (size < kAgree * pressed.weight) { return false; }
  let n = pressed.normal / size;
  let part = min(1.0, kHoldRate * step.time.dt / kHoldPart);
  let restored = min(part * pressed.gap, kHoldSpeed * step.time.dt);
  let ahead = step.time.dt * dot(n, velocity);
  aim[at] = vec4f(n, ahead + pressed.lack - (pressed.gap - restored));
  // Friction is of what all pairs bear, which where they press apart is more than their sum.
  aim[at + 1u] = vec4f(step.time.dt * pressed.surface, pressed.friction * pressed.weight / size);
  aim[at + 2u] = vec4f(restored, kPressed, select(0.0, 1.0, size >= kAlike * pressed.weight),
                       return_speed(velocity, pressed.surface, n));
  return true;
}
