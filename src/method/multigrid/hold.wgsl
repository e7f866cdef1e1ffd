// The matrix terms of obstacles in this substep: for each node an m and a k, for the block m mᵀ + k I that its contact
// adds to the matrix; then for each node what `finish` needs to know of its hold. The including kernel binds `holds`.
// Source: docs/solvers/multigrid.md, Contact.
#include "method/multigrid/hold_law.wgsl"
#include "method/symmetric.wgsl"
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

// The way of the obstacle's surface, m, and how far the node is to be restored, m; then λ + k g, N, μ, 1 where all
// that presses the node has about one direction, and k_t, N/m.
fn hold_way_at(node : u32) -> u32 { return arrayLength(&holds) / 3u + node; }
fn hold_force_at(node : u32) -> u32 { return arrayLength(&holds) / 3u * 2u + node; }
