// Adds the coarser level's correction on the finest level, x += P e. One invocation per node. Source: docs/solvers/multigrid.md, equation 7.
#include "gpu/index.wgsl"
#include "method/multigrid/correction.wgsl"
//                                                                          elements       unit
@group(0) @binding(0) var<uniform>             levels  : array<Level, 2>;
@group(0) @binding(1) var<storage, read>       place   : array<vec4f>;   // nx * ny        m (w: N/m; 0: held)
@group(0) @binding(2) var<storage, read_write> vectors : array<vec4f>;   // method/multigrid/level.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn correct_fine(@builtin(global_invocation_id) id : vec3u) {
  let level = levels[0];
  let node = flat_index(id);
  if (node >= level.nx * level.ny || place[node].w == 0.0) { return; }
  correct_node(level, levels[1], node);
}
