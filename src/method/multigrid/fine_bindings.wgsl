// Bindings of the kernels of a grid's finest level, whose matrix is in the poses of its springs.
#include "method/multigrid/grid_level.wgsl"
#include "element/spring/spring_grid.wgsl"
#include "state/step.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step    : StepBlock;
@group(0) @binding(1) var<uniform>             grid    : SpringGrid;
@group(0) @binding(2) var<uniform>             levels  : array<GridLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       place   : array<vec4f>;        // nx * ny        m (w: N/m; 0: fixed)
@group(0) @binding(4) var<storage, read>       holds   : array<vec4f>;        // method/multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(6) var<storage, read>       springs : array<vec2u>;        // method/multigrid/grid_springs.wgsl
