// Projects what obstacles ask of the nodes, at the end of a sweep. One invocation per node.
// Source: docs/solvers/xpbd.md, equations 19 and 20.
#include "gpu/index.wgsl"
#include "method/projection/projected_hold.wgsl"
//                                                                              elements            unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read_write> aim        : array<vec4f>;    // 4 * vertex_count    m
@group(0) @binding(2) var<storage, read_write> way        : array<vec4f>;    // vertex_count        m (w: 1/kg)

@compute @workgroup_size(kWorkgroupSize)
fn project_holds(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node < step.nodes.count) { project_hold(node); }
}
