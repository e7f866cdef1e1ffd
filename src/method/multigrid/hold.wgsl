// The matrix terms of obstacles in this substep: for each node a k and m, for the block k I + m mᵀ that its
// contact adds to the matrix. The including kernel binds `holds`. Source: docs/solvers/multigrid.md, Contact.
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
fn is_pressed(node : u32) -> bool { return kHolds && any(holds[node] != vec4f(0.0)); }
