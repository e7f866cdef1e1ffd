// Sums over the nodes of a cloth, in an order that no workgroup size changes: here of each kChunk nodes, and of those
// sums in add_up.wgsl. The including kernel binds `partials`.
#include "method/multigrid/chunks.wgsl"
#include "method/multigrid/cloth.wgsl"
var<workgroup> lanes : array<vec2f, kWorkgroupSize>;

// For all invocations of a workgroup at once; those past the last node have 0.
fn store_partial(local : u32, node : u32, count : u32, value : vec2f) {
  lanes[local] = value;
  workgroupBarrier();
  for (var half = kChunk / 2u; half > 0u; half /= 2u) {
    if (local % kChunk < half) { lanes[local] += lanes[local + half]; }
    workgroupBarrier();
  }
  if (local % kChunk == 0u && node < count) { partials[cloth * chunk_count(count) + node / kChunk] = lanes[local]; }
}
