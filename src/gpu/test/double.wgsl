// Doubles every value: the least kernel there is, for the tests of gpu/.
#include "gpu/index.wgsl"
//                                                                          elements
@group(0) @binding(0) var<storage, read_write> values : array<u32>;       // any

@compute @workgroup_size(kWorkgroupSize)
fn double(@builtin(global_invocation_id) id : vec3u) {
  let i = flat_index(id);
  if (i >= arrayLength(&values)) { return; }
  values[i] = 2u * values[i];
}
