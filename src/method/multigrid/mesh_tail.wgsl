// The V-cycle on the coarsest levels of a mesh, by one workgroup: tail.wgsl.
#include "method/multigrid/mesh_correction.wgsl"
#include "method/multigrid/mesh_operator.wgsl"
#include "method/multigrid/mesh_restriction.wgsl"
#include "method/multigrid/tail.wgsl"
// Mirror: kMeshTail, src/method/multigrid/bottom.hpp. Only the coarsest level of a mesh in pieces has more: a node of
// each, and no couplings.
const kTailNodes = 554u;
//                                                                                     elements
@group(0) @binding(0) var<storage, read>       tail          : array<MeshLevelParams>;  // the coarsest levels
@group(0) @binding(1) var<storage, read_write> vectors       : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       blocks        : array<vec2f>;        // method/multigrid/mesh_block.wgsl
@group(0) @binding(3) var<storage, read>       row_starts    : array<u32>;          // node_count + 1 of each level
@group(0) @binding(4) var<storage, read>       entries       : array<u32>;          // the node of each
@group(0) @binding(5) var<storage, read>       source_starts : array<u32>;          // node_count + 1 of each level
@group(0) @binding(6) var<storage, read>       sources       : array<Share>;        // of nodes of the finer level
@group(0) @binding(7) var<storage, read>       taps          : array<Share>;        // kTaps a node: coarser nodes
@group(0) @binding(8) var<uniform>             bottom        : BottomSweeps;

@compute @workgroup_size(kWorkgroupSize)
fn mesh_tail(@builtin(local_invocation_index) local : u32) { solve_tail(local); }
