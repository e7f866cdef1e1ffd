// Where cloth has met cloth in this substep, all nodes begin the next one without history: of two that a spring joins
// one would else go on by another formula than the other, and the spring would give both unequal impulses. One
// invocation per node. Source: docs/solvers/multigrid.md, The step.
#include "gpu/index.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "state/statistics.wgsl"
//                                                                             elements       unit
@group(0) @binding(0) var<uniform>             nodes      : ClothNodes;
@group(0) @binding(1) var<storage, read>       statistics : array<u32>;     // state/statistics.wgsl
@group(0) @binding(2) var<storage, read_write> velocity   : array<vec4f>;   // vertex_count   m/s (w: as in predict)

@compute @workgroup_size(kWorkgroupSize)
fn begin_anew(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count || statistics[kStatMeeting] == 0u) { return; }
  let node = nodes.first_vertex + id.z * nodes.count + index;
  velocity[node].w = min(velocity[node].w, 0.0);
}
