// Copies a buffer: what the adapter's memory gives a kernel that reads and writes every byte once. One invocation per
// sixteen bytes.
#include "gpu/index.wgsl"
//                                                                       elements
@group(0) @binding(0) var<storage, read>       source : array<vec4f>;
@group(0) @binding(1) var<storage, read_write> copied : array<vec4f>;   // as many

@compute @workgroup_size(kWorkgroupSize)
fn copy(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index < arrayLength(&copied)) { copied[index] = source[index]; }
}
