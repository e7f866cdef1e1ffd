// What pairs give their vertices, as sums of integers. The including kernel declares `vertex_contacts` as atomics.
#include "contact/proximity/friction.wgsl"
#include "state/contact.wgsl"

// The part of a vertex's mass that a pair has, in kShareUnits of the sum that it is a part of: equation (2).
fn share_units(urgency : f32, weight : f32) -> u32 { return u32(round(kShareUnits * urgency * abs(weight))); }

// Of a round that separates: a vertex's mass is shared by one more, and in how many parts it is.
fn share_mass(id : u32) { atomicAdd(&vertex_contacts[kVertexWords * (id & kIdBits) + kShareWord], 1u); }
fn share_count(id : u32) -> f32 {
  return f32(max(1u, atomicLoad(&vertex_contacts[kVertexWords * (id & kIdBits) + kShareWord])));
}

fn add_units(word : u32, units_in_one : f32, value : vec3f) {
  let units = vec3i(round(clamp(units_in_one * value, vec3f(-kMostUnits), vec3f(kMostUnits))));
  for (var axis = 0u; axis < 3u; axis++) {
    if (units[axis] != 0) { atomicAdd(&vertex_contacts[word + axis], bitcast<u32>(units[axis])); }
  }
}

// Moves the end of a vertex's way along n by so much, m, and its velocity, m/s.
fn move_by(vertex : u32, by : f32, by_speed : f32, n : vec3f) {
  if (by == 0.0) { return; }
  add_units(kVertexWords * vertex + kPushWord, kPushUnits, by * n);
  add_units(kVertexWords * vertex + kChangeWord, kSpeedUnits, by_speed * n);
}

// The part of an impulse or a force that the cone of friction about n allows.
fn within_cone(whole : vec3f, n : vec3f, friction : f32) -> vec3f {
  let normal = max(0.0, dot(n, whole));
  return normal * n + no_longer(part_across(whole, n), friction * normal);
}
