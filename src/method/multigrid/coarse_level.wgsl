// What the kernels of smoothing on a coarse level of a grid bind, and the steps that they take. The including kernel
// has operand(level, x, node).
#include "gpu/index.wgsl"
#include "method/multigrid/coarse_operator.wgsl"
#include "method/multigrid/steps.wgsl"
//                                                                                 elements
@group(0) @binding(0) var<uniform>             levels    : array<LevelOfGrid, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;        // method/multigrid/grid_block.wgsl
