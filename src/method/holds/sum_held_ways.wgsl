// The sums of pieces' nodes in parts of kPieceChunk, where obstacles may bear nodes in the sweeps. One invocation per
// node of a chunk. Source: docs/momentum.md, equation 2.
#include "gpu/index.wgsl"
#include "method/holds/node_holds.wgsl"
#include "method/pieces/way_sums.wgsl"
//                                                                              elements            unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<storage, read>       lists       : array<u32>;        // chunks.wgsl
@group(0) @binding(2) var<storage, read>       position_in : array<vec4f>;      // vertex_count        m
@group(0) @binding(3) var<storage, read>       aim         : array<vec4f>;      // 4 * vertex_count    m
@group(0) @binding(4) var<storage, read>       way         : array<vec4f>;      // vertex_count        m (w: 1/kg)
@group(0) @binding(5) var<storage, read_write> sums        : array<vec4f>;      // kPieceColumns * chunks

fn goes_free(node : u32) -> bool { return way[node].w != 0.0 && aim[hold_at(node) + 2u].y != kBears; }

@compute @workgroup_size(kWorkgroupSize)
fn sum_held_ways(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  sum_chunk(flat_index(id), local);
}
