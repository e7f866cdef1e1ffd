// Adds to what cloth gives a rigid body. Sums are of integers of 64 bits, since pairs have no order; as
// state/add_pair_sums.wgsl has them.
#include "contact/proximity/rigid.wgsl"

fn add_rigid_three(word : u32, value : vec3f) {
  let units = round(kRigidUnits * min(abs(value), vec3f(kMostRigid)));
  let size_high = vec3u(floor(units / 0x1p32));
  let size_low = vec3u(units - vec3f(size_high) * 0x1p32);
  let negative = value < vec3f(0.0);
  let ones = select(vec3u(0u), vec3u(0xffffffffu), negative);
  let low = select(size_low, ~size_low + 1u, negative);
  let high = (size_high ^ ones) + select(vec3u(0u), vec3u(1u), negative & (size_low == vec3u(0u)));
  for (var axis = 0u; axis < 3u; axis++) {
    if (low[axis] == 0u && high[axis] == 0u) { continue; }
    let before = atomicAdd(&rigid[word + 2u * axis], low[axis]);
    let more = high[axis] + select(0u, 1u, before + low[axis] < before);
    if (more != 0u) { atomicAdd(&rigid[word + 2u * axis + 1u], more); }
  }
}

// An impulse at the end of `arm`, or a push times a mass.
fn add_to_body(body : u32, sums : u32, arm : vec3f, impulse : vec3f) {
  let inverse_mass = rigid_number(body + kRigidInverseMass);
  add_rigid_three(body + sums, inverse_mass * impulse);
  add_rigid_three(body + sums + 6u, inverse_mass / rigid_number(body + kRigidExtent) * cross(arm, impulse));
}
