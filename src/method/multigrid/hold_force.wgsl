// The force that holds a node at obstacles: how it is kept, and what friction adds to it. The including kernel binds
// `presses`, and has a StepBlock `step`. Source: docs/solvers/multigrid.md, equation 11.
#include "contact/proximity/friction.wgsl"
#include "contact/proximity/press_sums.wgsl"
#include "method/multigrid/hold.wgsl"

struct HoldForce {
  along : vec3f,       // τ, N
  normal : f32,        // λ, N: what it bears, without what restores a gap
  under_cloth : bool,  // it was held, and its pairs keep the force instead
}
fn hold_force(vertex : u32) -> HoldForce {
  let at = kHoldWords * vertex;
  let words = bitcast<vec4f>(vec4i(presses[at], presses[at + 1u], presses[at + 2u], presses[at + 3u]));
  return HoldForce(words.xyz, max(words.w, 0.0), words.w < 0.0);
}
fn keep_hold_force(vertex : u32, force : HoldForce) {
  let words = bitcast<vec4i>(vec4f(force.along, select(force.normal, kUnderCloth, force.under_cloth)));
  for (var k = 0u; k < kHoldWords; k++) { presses[kHoldWords * vertex + k] = words[k]; }
}

// What friction of a hold depends on.
struct Grip {
  n : vec3f,
  kept : vec3f,         // τ, turned with the surface, N
  stiffness : f32,      // across, N/m
  surface_way : vec3f,  // m
  friction : f32,
}
fn turned(along : vec3f, n : vec3f) -> vec3f {
  let flat = part_across(along, n);
  let size = length(flat);
  return select(vec3f(0.0), length(along) / size * flat, size > 0.0);
}
fn reach_of(grip : Grip, way : vec3f) -> vec3f {
  return grip.kept - grip.stiffness * part_across(way - grip.surface_way, grip.n);
}
