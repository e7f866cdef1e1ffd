// Whether the next substep that may search has to. The including kernel binds step and statistics, and sets
// kDetectInterval. Source: docs/contact.md, Reach.
#include "state/statistics.wgsl"
#include "contact/proximity/reach.wgsl"

// Once a substep: no vertex's reach covers the travel of colliders, and crossings come apart ring by ring.
fn schedule_for_colliders() {
  atomicMax(&statistics[kStatCrossings], atomicLoad(&statistics[kStatCrossingsLeft]));
  let travel = bitcast<f32>(atomicLoad(&statistics[kStatTravel])) + step.contact.collider_travel;
  atomicStore(&statistics[kStatTravel], bitcast<u32>(travel));
  let next = kReachMargin * kDetectInterval * step.contact.collider_travel;
  let leaves_reach = next > 0.0 && travel + next > bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  if (leaves_reach || atomicLoad(&statistics[kStatCrossingsLeft]) != 0u) { atomicStore(&statistics[kStatDetect], 1u); }
}

// A vertex that is about to leave its reach.
fn schedule_for_vertex(reach : Reach, start : vec3f, end : vec3f) {
  let next = end + kReachMargin * kDetectInterval * (end - start);
  if (distance_from_way(reach, next) > reach.slack) { atomicStore(&statistics[kStatDetect], 1u); }
}
