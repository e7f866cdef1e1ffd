// The matrix terms of obstacles in this substep: for each node a k and m, for the block k I + m mᵀ that its
// contact adds to the matrix; then for each node the speed at which that brings it away from what it is too near to. It
// does not keep that. The including kernel binds `holds`. Source: docs/solvers/multigrid.md, Contact.
#include "method/multigrid/symmetric.wgsl"
override kHolds : bool = false;  // false: there is no contact to hold any, and `holds` is not read

fn hold_block(node : u32) -> Symmetric {
  let hold = holds[node];
  return sum_of(outer(hold.xyz, 1.0), identity(hold.w));
}
fn hold_product(node : u32, x : vec3f) -> vec3f {
  let hold = holds[node];
  return hold.w * x + dot(hold.xyz, x) * hold.xyz;
}
fn restored_at(node : u32) -> u32 { return arrayLength(&holds) / 2u + node; }  // of a vec3f, m/s
fn is_pressed(node : u32) -> bool { return kHolds && any(holds[node] != vec4f(0.0)); }
