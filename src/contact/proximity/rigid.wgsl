// Rigid bodies as the pairs of cloth meet them. The including kernel binds `rigid` as array<atomic<u32>>.
// Source: docs/rigid.md.
#include "state/contact.wgsl"
#include "contact/proximity/rigid_words.wgsl"
override kRigid : bool = false;  // whether the scene has any, and `rigid` is that buffer
const kRigidPair = 0x80000000u;  // of `other_end` of a pair with one: its collider above kOfOneSystem, kComesOnFront
const kRigidShift = 2u;

fn rigid_number(word : u32) -> f32 { return bitcast<f32>(atomicLoad(&rigid[word])); }
fn rigid_vector(word : u32) -> vec3f {
  return vec3f(rigid_number(word), rigid_number(word + 1u), rigid_number(word + 2u));
}

fn has_body(contact : Contact) -> bool {
  return kRigid && (contact.other_end & kRigidPair) != 0u && !is_crossing(contact.ids) && !is_self_pair(contact.ids);
}
fn sides_with_body(sides : u32, collider : u32) -> u32 {
  return kRigidPair | (collider << kRigidShift) | (sides & (kOfOneSystem | kComesOnFront));
}
fn body_words(contact : Contact) -> u32 { return kRigidWords * ((contact.other_end & ~kRigidPair) >> kRigidShift); }
// 1: the body is side A of the pair; -1: side B.
fn body_side(ids : vec4u) -> f32 { return select(-1.0, 1.0, is_collider(ids.x)); }

// R' I⁻¹ R'ᵀ, the columns.
fn inverse_inertia(body : u32) -> mat3x3f {
  let d = rigid_vector(body + kRigidInverse);
  let b = rigid_vector(body + kRigidInverse + 3u);
  return mat3x3f(d.x, b.x, b.y, b.x, d.y, b.z, b.y, b.z, d.z);
}
// K v: how the velocity at the end of `arm` changes with an impulse v there.
fn body_mobility(body : u32, inertia : mat3x3f, arm : vec3f, v : vec3f) -> vec3f {
  return rigid_number(body + kRigidInverseMass) * v + cross(inertia * cross(arm, v), arm);
}
// The velocity at the end of `arm`, before impulses of cloth, and what those so far have changed of it.
fn free_velocity(body : u32, arm : vec3f) -> vec3f {
  return rigid_vector(body + kRigidFree) + cross(rigid_vector(body + kRigidFreeSpin), arm);
}
fn given_velocity(body : u32, inertia : mat3x3f, arm : vec3f) -> vec3f {
  return rigid_number(body + kRigidInverseMass) * rigid_vector(body + kRigidGiven) +
         cross(inertia * rigid_vector(body + kRigidGivenTurn), arm);
}

// Any direction square to n, unit.
fn across(n : vec3f) -> vec3f {
  let other = select(vec3f(0.0, 1.0, 0.0), vec3f(1.0, 0.0, 0.0), abs(n.x) < 0.6);
  let s = cross(n, other);
  return s / length(s);
}
