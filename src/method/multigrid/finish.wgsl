// The last smoothing sweep, and with it the substep's end: the node's new position and velocity. One invocation per
// node. Source: docs/solvers/multigrid.md, equations 8 and 9.
#include "gpu/index.wgsl"
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/fine_operator.wgsl"
#include "method/multigrid/finish_node.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<uniform>             nodes        : ClothNodes;
@group(0) @binding(2) var<uniform>             grid         : SpringGrid;
@group(0) @binding(3) var<uniform>             levels       : array<GridLevelParams, 2>;
@group(0) @binding(4) var<storage, read>       place        : array<vec4f>;   // nx * ny        m (w: N/m; 0: fixed)
@group(0) @binding(5) var<storage, read>       holds        : array<vec4f>;   // method/multigrid/hold.wgsl
@group(0) @binding(6) var<storage, read>       vectors      : array<vec4f>;   // method/multigrid/cloth.wgsl
@group(0) @binding(7) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(8) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count   m/s (w: as in predict)
@group(0) @binding(9) var<storage, read_write> position_out : array<vec4f>;   // vertex_count   m; came as a step before
@group(0) @binding(10) var<storage, read_write> velocity_out : array<vec4f>;  // vertex_count   m/s

@compute @workgroup_size(kWorkgroupSize)
fn finish(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  if (place[index].w == 0.0) {
    finish_held(index);
    return;
  }
  let level = levels[0];
  let left = vectors[vector_at(level, kResidual, index)].xyz - product(level, kSecond, index);
  let d = vectors[vector_at(level, kDirection, index)].xyz;
  finish_free(index, operand(level, kSecond, index) + kKeep * d + kTake * times(inverse_at(level, index), left));
}
