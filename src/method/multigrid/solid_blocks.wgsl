// The matrix of a body with volume without its inertia: the sums of what tetrahedra are for two nodes. One invocation
// per block. Source: docs/bodies.md, All nodes at once.
#include "gpu/index.wgsl"
#include "method/multigrid/element_part.wgsl"
#include "method/multigrid/solid_term.wgsl"
//                                                                              elements
@group(0) @binding(0) var<uniform>             levels   : array<MeshLevelParams, 2>;
@group(0) @binding(1) var<storage, read>       place    : array<vec4f>;     // node_count  w: N/m, 0: fixed
@group(0) @binding(2) var<storage, read>       terms    : array<vec4f>;     // method/multigrid/solid_term.wgsl
@group(0) @binding(3) var<storage, read>       parts    : array<u32>;       // rows of blocks, then their parts
@group(0) @binding(4) var<storage, read>       targets  : array<vec2u>;     // the entries of each block
@group(0) @binding(5) var<storage, read>       entries  : array<u32>;       // the node of each
@group(0) @binding(6) var<storage, read_write> blocks   : array<vec2f>;     // method/multigrid/mesh_block.wgsl

fn block_of_part(part : u32) -> Block {
  return block_of_tet(tet_term_of(element_of(part)), row_of(part), column_of(part));
}

@compute @workgroup_size(kWorkgroupSize)
fn solid_blocks(@builtin(global_invocation_id) id : vec3u) { sum_block(flat_index(id)); }
