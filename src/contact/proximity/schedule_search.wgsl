// Whether the next substep that may search has to, whatever the vertices do. The including kernel binds step and
// statistics. Source: docs/contact.md, Reach.
#include "state/statistics.wgsl"

// Once a substep: no vertex's reach covers the travel of colliders, and crossings come apart ring by ring.
fn schedule_for_colliders() {
  atomicMax(&statistics[kStatCrossings], atomicLoad(&statistics[kStatCrossingsLeft]));
  let own = max(step.contact.collider_travel, bitcast<f32>(atomicLoad(&statistics[kStatBodyTravel])));
  let travel = bitcast<f32>(atomicLoad(&statistics[kStatTravel])) + own;
  atomicStore(&statistics[kStatTravel], bitcast<u32>(travel));
  let next = kReachMargin * kDetectInterval * own;
  let leaves_reach = next > 0.0 && travel + next > bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  if (leaves_reach || atomicLoad(&statistics[kStatCrossingsLeft]) != 0u) { atomicStore(&statistics[kStatDetect], 1u); }
}
