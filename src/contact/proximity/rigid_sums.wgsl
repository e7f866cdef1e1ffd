// Adds to what cloth gives a rigid body. Sums are of integers of 64 bits, since pairs have no order.
#include "contact/proximity/rigid.wgsl"
#include "state/wide.wgsl"

fn add_rigid_three(word : u32, value : vec3f) {
  let wide = wide_of(value, kRigidUnits, kMostRigid);
  for (var axis = 0u; axis < 3u; axis++) {
    let low = wide.low[axis];
    if (low == 0u && wide.high[axis] == 0u) { continue; }
    let before = atomicAdd(&rigid[word + 2u * axis], low);
    let more = wide.high[axis] + select(0u, 1u, before + low < before);
    if (more != 0u) { atomicAdd(&rigid[word + 2u * axis + 1u], more); }
  }
}

// An impulse at the end of `arm`, or a push times a mass.
fn add_to_body(body : u32, sums : u32, arm : vec3f, impulse : vec3f) {
  let inverse_mass = rigid_number(body + kRigidInverseMass);
  add_rigid_three(body + sums, inverse_mass * impulse);
  add_rigid_three(body + sums + 6u, inverse_mass / rigid_number(body + kRigidExtent) * cross(arm, impulse));
}
