// Adds the gas in a closed cloth to the equation of every free node, as a force that a substep's systems share. One
// invocation per node of a cloth, after `predict` or `predict_again`. Source: docs/pressure.md, equation 6.
#include "gpu/index.wgsl"
#include "method/gas_force.wgsl"
#include "method/multigrid/cloth.wgsl"
//                                                                          elements       unit
@group(0) @binding(0) var<uniform>             nodes   : ClothNodes;
@group(0) @binding(1) var<storage, read>       gases   : array<Gas>;
@group(0) @binding(2) var<storage, read>       slopes  : array<vec4f>;   // vertex_count   m² (w: 1 + gas, or 0)
@group(0) @binding(3) var<storage, read>       place   : array<vec4f>;   // count          m (w: N/m; 0: fixed)
@group(0) @binding(4) var<storage, read_write> vectors : array<vec4f>;   // cloth.wgsl: the finest

@compute @workgroup_size(kWorkgroupSize)
fn add_gas(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= nodes.count || place[node].w == 0.0) { return; }
  vectors[kResidual * nodes.count + node] += vec4f(gas_force(nodes.first_vertex + node), 0.0);
}
