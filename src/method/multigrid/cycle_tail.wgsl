// The V-cycle on the coarsest levels of a grid, by one workgroup a cloth: tail.wgsl.
#include "method/multigrid/coarse_operator.wgsl"
#include "method/multigrid/grid_correction.wgsl"
#include "method/multigrid/grid_restriction.wgsl"
#include "method/multigrid/lone_lane.wgsl"
#include "method/multigrid/tail.wgsl"
const kTailNodes = 682u;  // mirror: kGridTail, src/method/multigrid/bottom.hpp
//                                                                                 elements
@group(0) @binding(0) var<storage, read>       tail      : array<GridLevelParams>;  // the coarsest levels, finest first
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;        // method/multigrid/grid_block.wgsl
@group(0) @binding(3) var<uniform>             bottom    : BottomSweeps;

@compute @workgroup_size(kWorkgroupSize)
fn cycle_tail(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = group.z;
  solve_tail(local);
}
