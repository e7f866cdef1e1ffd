// What the kernels of smoothing on a level of a mesh bind, and the steps that they take.
#include "gpu/index.wgsl"
#include "method/multigrid/mesh_operator.wgsl"
#include "method/multigrid/steps.wgsl"
//                                                                                  elements
@group(0) @binding(0) var<uniform>             levels     : array<LevelOfMesh, 2>;
@group(0) @binding(1) var<storage, read_write> vectors    : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       blocks     : array<vec4f>;        // method/multigrid/mesh_block.wgsl
@group(0) @binding(3) var<storage, read>       row_starts : array<u32>;          // node_count + 1 of each level
@group(0) @binding(4) var<storage, read>       rows       : array<Coupling>;
