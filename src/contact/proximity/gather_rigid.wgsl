// Between two iterations of impulses: the next begins from what the one before has given the bodies. One invocation per
// collider. Source: docs/rigid.md, Cloth.
#include "gpu/index.wgsl"
#include "contact/proximity/take_rigid_sums.wgsl"
//                                                                           elements
@group(0) @binding(0) var<storage, read_write> rigid : array<u32>;        // kRigidWords * colliders

@compute @workgroup_size(kWorkgroupSize)
fn gather_rigid(@builtin(global_invocation_id) id : vec3u) {
  let body = kRigidWords * flat_index(id);
  if (body >= arrayLength(&rigid) || number_at(body + kRigidInverseMass) == 0.0) { return; }
  let more = take_sums(body, kRigidSums);
  set_vector(body + kRigidGiven, vector_at(body + kRigidGiven) + more.linear);
  set_vector(body + kRigidGivenTurn, vector_at(body + kRigidGivenTurn) + more.angular);
}
