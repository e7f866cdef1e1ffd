// r·z of the residual and what a V-cycle makes of it. One invocation per node. Source: docs/solvers/multigrid.md,
// equation 14.
#include "method/multigrid/fine_vectors.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn weigh(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  let node = flat_index(id);
  let level = Level(nodes.count);
  var part = 0.0;
  if (node < nodes.count && !is_solved()) {
    part = dot(vectors[vector_at(level, kResidual, node)].xyz, vectors[vector_at(level, kFirst, node)].xyz);
  }
  store_partial(local, node, nodes.count, vec2f(part, 0.0));
}
