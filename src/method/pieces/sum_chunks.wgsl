// The sums of pieces' nodes in parts of kPieceChunk, in an order that no workgroup size changes. The including kernel
// binds `lists` and `sums`, has one invocation per node of a chunk, and says what a node has by
// sums_of(node, first_node).
#include "method/pieces/chunks.wgsl"
var<workgroup> lanes : array<mat4x4f, kWorkgroupSize>;

fn sum_chunk(lane : u32, local : u32) {
  let chunks = arrayLength(&sums) / kPieceColumns;
  let chunk = lane / kPieceChunk;
  let at = lane % kPieceChunk;
  lanes[local] = mat4x4f();
  if (chunk < chunks) {
    let own = chunk_at(chunk);
    if (at < own.count) { lanes[local] = sums_of(node_at(chunks, own.first + at), own.first_node); }
  }
  workgroupBarrier();
  for (var half = kPieceChunk / 2u; half > 0u; half /= 2u) {
    if (at < half) { lanes[local] += lanes[local + half]; }
    workgroupBarrier();
  }
  if (at != 0u || chunk >= chunks) { return; }
  for (var column = 0u; column < 4u; column++) { sums[kPieceColumns * chunk + column] = lanes[local][column]; }
}
