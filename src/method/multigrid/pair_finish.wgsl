// Gives vertices what their held pairs take out of their velocities; those have no history. Clears their sums. One
// invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "state/pair_sums.wgsl"
const kHeldByOther = -3.0;  // of a velocity's w: the node's body does not go free. Mirror: method/pieces/sum_steps.wgsl
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             nodes     : ClothNodes;
@group(0) @binding(1) var<storage, read>       place     : array<vec4f>;     // count          w: N/m, 0: fixed
@group(0) @binding(2) var<storage, read_write> velocity  : array<vec4f>;     // vertex_count   m/s
@group(0) @binding(3) var<storage, read_write> pair_sums : array<u32>;

@compute @workgroup_size(kWorkgroupSize)
fn pair_finish(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  let among_all = id.z * nodes.count + index;
  let vertex = nodes.first_vertex + among_all;
  if (!is_held_by_pairs(vertex)) { return; }
  let change = take_pair_sum(vertex);
  let by_other = pair_sums[kSumWords * vertex + kOfOtherWord] != 0u;
  pair_sums[kSumWords * vertex] = 0u;
  pair_sums[kSumWords * vertex + kOfOtherWord] = 0u;
  if (place[among_all].w == 0.0) { return; }
  let v = velocity[vertex];
  velocity[vertex] = vec4f(v.xyz + change, select(min(v.w, 0.0), kHeldByOther, by_other && v.w >= 0.0));
}
