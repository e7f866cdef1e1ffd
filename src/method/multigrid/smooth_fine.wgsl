// The second smoothing sweep on the finest level of a grid: x += keep d + take D⁻¹ (r - A x) with x = d, the first
// sweep. One invocation per node. Source: docs/solvers/multigrid.md, equation 8.
#include "method/multigrid/fine_level.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn smooth_fine(@builtin(global_invocation_id) id : vec3u) {
  let level = levels[0];
  let node = flat_index(id);
  if (node >= node_count(level)) { return; }
  let d = operand(level, kDirection, node);
  let x = d + kKeep * d + kTake * times(inverse_at(level, node), left_of(level, kDirection, node));
  vectors[vector_at(level, kFirst, node)] = vec4f(x, 0.0);
}
