// Bindings and sweeps of the smoothing kernels of a mesh's levels.
#include "gpu/index.wgsl"
#include "method/multigrid/keep_vector.wgsl"
#include "method/multigrid/mesh_operator.wgsl"
#include "method/multigrid/operand.wgsl"
#include "method/multigrid/smoothing.wgsl"
//                                                                                  elements
@group(0) @binding(0) var<uniform>             levels     : array<MeshLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors    : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       blocks     : array<vec2f>;        // method/multigrid/mesh_block.wgsl
@group(0) @binding(3) var<storage, read>       row_starts : array<u32>;          // node_count + 1 of each level
@group(0) @binding(4) var<storage, read>       entries    : array<u32>;          // the node of each
