// The air's part of a node's block on the matrix's diagonal, N/m, as `add_air` has left it: the layout of kInverse.
// The including kernel binds `vectors` and has the Level of the finest.
#include "method/symmetric.wgsl"
override kAirPushes : bool = false;  // false: there are no such vectors

fn air_block(level : Level, node : u32) -> Symmetric {
  let a = vectors[vector_at(level, kAir, node)];
  let b = vectors[vector_at(level, kAir + 1u, node)];
  return Symmetric(a.xyz, vec3f(a.w, b.xy));
}
