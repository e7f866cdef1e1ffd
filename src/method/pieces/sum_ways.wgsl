// The sums of pieces' nodes in parts of kPieceChunk, of a method that moves ways. One invocation per node of a chunk.
// Source: docs/momentum.md, equation 2.
#include "gpu/index.wgsl"
#include "method/pieces/way_sums.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<storage, read>       lists       : array<u32>;        // chunks.wgsl
@group(0) @binding(1) var<storage, read>       position_in : array<vec4f>;      // vertex_count   m
@group(0) @binding(2) var<storage, read>       aim         : array<vec4f>;      // vertex_count   m
@group(0) @binding(3) var<storage, read>       way         : array<vec4f>;      // vertex_count   m (w: 1/kg; 0: held)
@group(0) @binding(4) var<storage, read_write> sums        : array<vec4f>;      // kPieceColumns * chunks

fn goes_free(node : u32) -> bool { return way[node].w != 0.0; }

@compute @workgroup_size(kWorkgroupSize)
fn sum_ways(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  sum_chunk(flat_index(id), local);
}
