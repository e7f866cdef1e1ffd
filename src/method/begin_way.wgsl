// What the gas in closed cloths pushes each node with, N, where the node's way will be: what predict_way and start_way
// take from there. One invocation per node. Source: docs/pressure.md, equation 3.
#include "gpu/index.wgsl"
#include "method/gas_force.wgsl"
//                                                                            elements       unit
@group(0) @binding(0) var<storage, read>       gases  : array<Gas>;
@group(0) @binding(1) var<storage, read>       slopes : array<vec4f>;      // vertex_count   m² (w: 1 + gas, or 0)
@group(0) @binding(2) var<storage, read_write> way    : array<vec4f>;      // vertex_count   N

@compute @workgroup_size(kWorkgroupSize)
fn begin_way(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= arrayLength(&slopes)) { return; }
  way[node] = vec4f(gas_force(node), 0.0);
}
