// How far a system takes each node: where the next is linearised, and the velocity that leads there, for contact.
// Clears the count of the node's held pairs. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "state/pair_sums.wgsl"
#include "state/step.wgsl"
//                                                                                elements        unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             nodes       : ClothNodes;
@group(0) @binding(2) var<storage, read>       place       : array<vec4f>;     // count           m (w: N/m; 0: fixed)
@group(0) @binding(3) var<storage, read_write> vectors     : array<vec4f>;     // cloth.wgsl: the finest
@group(0) @binding(4) var<storage, read_write> predicted   : array<vec4f>;     // vertex_count    m/s
@group(0) @binding(5) var<storage, read_write> pair_sums   : array<u32>;       // state/pair_holds.wgsl
override kPairs : bool = false;
override kHolds : bool = false;  // whether contact reads where nodes are led

@compute @workgroup_size(kWorkgroupSize)
fn go_on(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  let among_all = id.z * nodes.count + index;
  let node = nodes.first_vertex + among_all;
  let first = id.z * nodes.vectors + index;
  let way_at = first + kWay * nodes.count;
  if (place[among_all].w != 0.0) {
    vectors[way_at] += vec4f(vectors[first + kSolution * nodes.count].xyz, 1.0);
  }
  if (kHolds) { predicted[node] = vec4f(vectors[way_at].xyz / step.time.dt, 0.0); }
  if (kPairs) { pair_sums[kSumWords * node] = 0u; }
}
