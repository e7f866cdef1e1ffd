// Adds the coarser level's correction on the finest level of a grid. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/grid_correction.wgsl"
#include "method/multigrid/keep_vector.wgsl"
#include "method/multigrid/level_solution.wgsl"
#include "method/multigrid/solve.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             levels  : array<GridLevelParams, 2>;
@group(0) @binding(1) var<storage, read>       place   : array<vec4f>;        // nx * ny        m (w: N/m; 0: fixed)
@group(0) @binding(2) var<storage, read_write> vectors : array<vec4f>;        // method/multigrid/cloth.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn correct_fine(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let node = flat_index(id);
  if (node >= node_count(levels[0]) || is_solved()) { return; }
  if (place[among_all(levels[0], node)].w != 0.0) { correct_node(levels[0], levels[1], node); }
}
