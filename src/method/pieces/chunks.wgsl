// The chunk of nodes that an invocation has a part in. The including kernel binds `lists`.
#include "method/pieces/piece.wgsl"

fn chunk_at(chunk : u32) -> PieceChunk {
  let at = kChunkWords * chunk;
  return PieceChunk(lists[at], lists[at + 1u], lists[at + 2u], lists[at + 3u]);
}
fn node_at(chunks : u32, place : u32) -> u32 { return lists[kChunkWords * chunks + place]; }
