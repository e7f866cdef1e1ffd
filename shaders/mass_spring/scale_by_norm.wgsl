// x = y / norm. One invocation per node.
#include "shared/index.wgsl"
//                                                                       elements
@group(0) @binding(0) var<storage, read>       y    : array<vec4f>;      // count
@group(0) @binding(1) var<storage, read>       norm : array<f32>;        // 1
@group(0) @binding(2) var<storage, read_write> x    : array<vec4f>;      // count

@compute @workgroup_size(kWorkgroupSize)
fn scale_by_norm(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= arrayLength(&x)) { return; }
  x[node] = y[node] / max(norm[0], 1e-30);
}
