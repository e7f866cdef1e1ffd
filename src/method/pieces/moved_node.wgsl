// By how much an invocation's node moves, as turn_pieces has found. The including kernel binds `lists`, `sums`, `turns`
// and `position_in`, and has one invocation per node of a chunk. Source: docs/momentum.md.
#include "method/pieces/chunks.wgsl"
const kNoNode = 0xffffffffu;

struct MovedNode {
  node : u32,  // kNoNode: the invocation has none
  by : vec3f,  // m
}
fn moved_node(lane : u32) -> MovedNode {
  let chunks = arrayLength(&sums) / kPieceColumns;
  let none = MovedNode(kNoNode, vec3f(0.0));
  if (lane / kPieceChunk >= chunks) { return none; }
  let own = chunk_at(lane / kPieceChunk);
  if (lane % kPieceChunk >= own.count) { return none; }
  let node = node_at(chunks, own.first + lane % kPieceChunk);
  let q = position_in[node].xyz - position_in[own.first_node].xyz;
  let first = kTurnColumns * own.piece;
  return MovedNode(node, turns[first].xyz + cross(turns[first + 1u].xyz, q));
}
