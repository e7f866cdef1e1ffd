// Moves the ways of each piece's nodes as turn_pieces has found. One invocation per node of a chunk.
// Source: docs/momentum.md.
#include "gpu/index.wgsl"
#include "method/pieces/moved_node.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<storage, read>       lists       : array<u32>;        // chunks.wgsl
@group(0) @binding(1) var<storage, read>       sums        : array<vec4f>;      // kPieceColumns * chunks
@group(0) @binding(2) var<storage, read>       turns       : array<vec4f>;      // kTurnColumns * pieces   m, rad
@group(0) @binding(3) var<storage, read>       position_in : array<vec4f>;      // vertex_count   m
@group(0) @binding(4) var<storage, read_write> way         : array<vec4f>;      // vertex_count   m (w: 1/kg)

@compute @workgroup_size(kWorkgroupSize)
fn move_ways(@builtin(global_invocation_id) id : vec3u) {
  let moved = moved_node(flat_index(id));
  if (moved.node == kNoNode) { return; }
  way[moved.node] = vec4f(way[moved.node].xyz + moved.by, way[moved.node].w);
}
