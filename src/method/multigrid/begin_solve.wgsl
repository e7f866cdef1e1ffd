// The start of conjugate gradients: the residual's norm, and its product with the guess, which `predict` has left as
// p. One invocation per node. Source: docs/solvers/multigrid.md, equation 13.
#include "method/multigrid/fine_vectors.wgsl"

@compute @workgroup_size(kWorkgroupSize)
fn begin_solve(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = id.z;
  let node = flat_index(id);
  let level = finest();
  var part = vec2f(0.0);
  if (node < nodes.count) {
    let r = vectors[vector_at(level, kResidual, node)].xyz;
    part = vec2f(dot(r, times(inverse_at(level, node), r)), dot(r, vectors[vector_at(level, kSearch, node)].xyz));
    vectors[vector_at(level, kSolution, node)] = vec4f(0.0);
  }
  store_partial(local, node, nodes.count, part);
}
