// Counts the nodes whose state is not finite. One invocation per node. The test is on the exponent's bits: WGSL lets a
// compiler assume that NaN and Inf do not occur, and `x != x` is false for NaN on real ones.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
//                                                                              elements
@group(0) @binding(0) var<storage, read>       position   : array<vec4u>;       // vertex_count, bits of m
@group(0) @binding(1) var<storage, read>       velocity   : array<vec4u>;       // vertex_count, bits of m/s
@group(0) @binding(2) var<storage, read_write> statistics : array<atomic<u32>>; // see state/statistics.wgsl
const kExponent = 0x7f800000u;

@compute @workgroup_size(kWorkgroupSize)
fn guard(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  // A frame that is to be run again does not count.
  if (node >= arrayLength(&position) || atomicLoad(&statistics[kStatRolledBack]) != 0u) { return; }
  let x = (position[node].xyz & vec3u(kExponent)) == vec3u(kExponent);
  let v = (velocity[node].xyz & vec3u(kExponent)) == vec3u(kExponent);
  if (any(x) || any(v)) { atomicAdd(&statistics[kStatNonfinite], 1u); }
}
