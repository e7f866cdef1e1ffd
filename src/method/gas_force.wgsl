// The force of the gas on a node, N; 0 where its cloth encloses none. The including kernel binds `gases` and `slopes`.
// Source: docs/pressure.md, equation 3.
#include "method/gas.wgsl"

fn gas_force(node : u32) -> vec3f {
  let slope = slopes[node];
  if (slope.w == 0.0) { return vec3f(0.0); }
  return gases[u32(slope.w) - 1u].gauge * slope.xyz;
}
