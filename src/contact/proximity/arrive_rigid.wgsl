// At the end of a substep: rigid bodies are where their ways end, with what cloth has given them. One invocation per
// collider. Source: docs/rigid.md, equation (3).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "gpu/finite.wgsl"
#include "contact/proximity/slow.wgsl"
#include "contact/proximity/take_rigid_sums.wgsl"
#include "contact/proximity/rigid_turn.wgsl"
//                                                                                elements
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read_write> rigid      : array<u32>;        // kRigidWords * colliders
@group(0) @binding(2) var<storage, read_write> statistics : array<atomic<u32>>;

@compute @workgroup_size(kWorkgroupSize)
fn arrive_rigid(@builtin(global_invocation_id) id : vec3u) {
  let body = kRigidWords * flat_index(id);
  if (body >= arrayLength(&rigid) || number_at(body + kRigidInverseMass) == 0.0) { return; }
  // Where the substep has ended before its time for all cloth, so much less was given: docs/contact.md, (6h).
  let ended = atomicLoad(&statistics[kStatDelayUs]) != atomicLoad(&statistics[kStatDelayBefore]);
  let part = select(1.0, part_of_all(), ended);
  let more = take_sums(body, kRigidSums);
  let linear = part * (vector_at(body + kRigidGiven) + more.linear);
  let angular = part * (vector_at(body + kRigidGivenTurn) + more.angular);
  let inverse_mass = number_at(body + kRigidInverseMass);
  let velocity = vector_at(body + kRigidFree) + inverse_mass * linear;
  let momentum = vector_at(body + kRigidMomentum) + angular;
  let place = vector_at(body + kRigidNext);
  let turn = quaternion_at(body + kRigidNextTurn);
  let pushes = take_sums(body, kRigidPushes);
  let inertia = vector_at(body + kRigidInertia);
  let near = rigid[body + kRigidNear];
  let before = vector_at(body + kRigidLift);
  // What an obstacle bears of a body, cloth between both does not: while it lies there, it is as if it bore it.
  let lift = select(linear, before, near != 0u && length(linear) <= length(before));
  var lack = select(0.0, bitcast<f32>(near) - step.contact.thickness, near != 0u);
  if (length(lift) > 0.0) { lack -= dot(place - vector_at(body + kRigidPlace), lift) / length(lift); }
  set_vector(body + kRigidLift, lift);
  set_number(body + kRigidLack, lack);
  rigid[body + kRigidNear] = 0u;
  set_vector(body + kRigidPlace, place);
  set_quaternion(body + kRigidTurn, turn);
  set_vector(body + kRigidVelocity, velocity);
  set_vector(body + kRigidMomentum, momentum);
  set_vector(body + kRigidPush, inverse_mass / step.time.dt * pushes.linear);
  set_vector(body + kRigidPushTurn, spin_of(inertia, turn, pushes.angular) / step.time.dt);
  rigid[body + kRigidShares] = 0u;
  if (!(is_finite(place) && is_finite(velocity) && is_finite(momentum))) {
    atomicAdd(&statistics[kStatNonfinite], 1u);
  }
}
