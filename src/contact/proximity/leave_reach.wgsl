// Asks for a search where a vertex, as it goes on, leaves its reach before the next chance to search. One invocation
// per vertex. Source: docs/contact.md, Reach.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/reach.wgsl"
//                                                                            elements          unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read>       previous   : array<vec4f>;  // vertex_count      m
@group(0) @binding(2) var<storage, read>       position   : array<vec4f>;  // vertex_count      m: where it comes
@group(0) @binding(3) var<storage, read>       predicted  : array<vec4f>;  // 3 * vertex_count  m: reach.wgsl
@group(0) @binding(4) var<storage, read_write> statistics : array<atomic<u32>>;

@compute @workgroup_size(kWorkgroupSize)
fn leave_reach(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  let found = predicted[step.nodes.count + vertex];
  let reach = Reach(found.xyz, found.w, predicted[2u * step.nodes.count + vertex].xyz);
  let start = previous[vertex].xyz;
  let next = start + kReachMargin * kDetectInterval * (position[vertex].xyz - start);
  if (distance_from_way(reach, next) > reach.slack) { atomicStore(&statistics[kStatDetect], 1u); }
}
