// Sums over the nodes of a cloth, in an order that no workgroup size changes: here of each kChunk nodes, and of those
// sums in add_up.wgsl. The including kernel binds `partials`.
#include "method/multigrid/chunks.wgsl"
#include "method/multigrid/cloth.wgsl"
var<workgroup> lanes : array<vec2f, kWorkgroupSize>;

// For all invocations of a workgroup at once, so many a node, of which the first has its value; those past the last
// node have 0.
fn store_partial(local : u32, invocations : u32, node : u32, count : u32, value : vec2f) {
  if (local % invocations == 0u) { lanes[local / invocations] = value; }
  workgroupBarrier();
  let is_summing = local < kWorkgroupSize / invocations;
  for (var half = kChunk / 2u; half > 0u; half /= 2u) {
    if (is_summing && local % kChunk < half) { lanes[local] += lanes[local + half]; }
    workgroupBarrier();
  }
  let first = node - local / invocations + local;
  if (is_summing && local % kChunk == 0u && first < count) {
    partials[cloth * chunk_count(count) + first / kChunk] = lanes[local];
  }
}
