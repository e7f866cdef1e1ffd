// Moves the ways of each piece's nodes as turn_pieces has found. One invocation per node of a chunk.
// Source: docs/momentum.md.
#include "gpu/index.wgsl"
#include "method/pieces/chunks.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<storage, read>       lists       : array<u32>;        // chunks.wgsl
@group(0) @binding(1) var<storage, read>       sums        : array<vec4f>;      // kPieceColumns * chunks
@group(0) @binding(2) var<storage, read>       turns       : array<vec4f>;      // kTurnColumns * pieces   m, rad
@group(0) @binding(3) var<storage, read>       position_in : array<vec4f>;      // vertex_count   m
@group(0) @binding(4) var<storage, read_write> way         : array<vec4f>;      // vertex_count   m (w: 1/kg)

@compute @workgroup_size(kWorkgroupSize)
fn move_ways(@builtin(global_invocation_id) id : vec3u) {
  let lane = flat_index(id);
  let chunks = arrayLength(&sums) / kPieceColumns;
  let chunk = lane / kPieceChunk;
  if (chunk >= chunks) { return; }
  let own = chunk_at(chunk);
  if (lane % kPieceChunk >= own.count) { return; }
  let node = node_at(chunks, own.first + lane % kPieceChunk);
  let q = position_in[node].xyz - position_in[own.first_node].xyz;
  let first = kTurnColumns * own.piece;
  way[node] = vec4f(way[node].xyz + turns[first].xyz + cross(turns[first + 1u].xyz, q), way[node].w);
}
