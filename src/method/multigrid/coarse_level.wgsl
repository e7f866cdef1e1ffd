// Bindings and sweeps of the smoothing kernels of a grid's coarse levels. The including kernel has
// operand(level, x, node).
#include "gpu/index.wgsl"
#include "method/multigrid/coarse_operator.wgsl"
#include "method/multigrid/smoothing.wgsl"
//                                                                                 elements
@group(0) @binding(0) var<uniform>             levels    : array<GridLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;        // method/multigrid/grid_block.wgsl
