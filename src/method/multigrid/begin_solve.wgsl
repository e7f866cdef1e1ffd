// The start of conjugate gradients: the residual's norm, and its product with the guess, which `predict` has left as
// p. One invocation per node. Source: docs/solvers/multigrid.md, equation 13.
#include "method/multigrid/fine_vectors.wgsl"
#include "state/pair_sums.wgsl"
//                                                                                 elements
@group(0) @binding(3) var<storage, read>       place     : array<vec4f>;        // count  w: N/m, 0: fixed
@group(0) @binding(4) var<storage, read_write> pair_sums : array<u32>;          // state/pair_holds.wgsl
override kPairs : bool = false;  // true: pairs may be held apart, and the residual gets their forces

@compute @workgroup_size(kWorkgroupSize)
fn begin_solve(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = id.z;
  let node = flat_index(id);
  let level = finest();
  var part = vec2f(0.0);
  if (node < nodes.count) {
    var r = vectors[vector_at(level, kResidual, node)].xyz;
    let vertex = nodes.first_vertex + cloth * nodes.count + node;
    if (kPairs && is_held_by_pairs(vertex)) {
      r += place[cloth * nodes.count + node].w * take_pair_sum(vertex);
      vectors[vector_at(level, kResidual, node)] = vec4f(r, 0.0);
    }
    part = vec2f(dot(r, times(inverse_at(level, node), r)), dot(r, vectors[vector_at(level, kSearch, node)].xyz));
    vectors[vector_at(level, kSolution, node)] = vec4f(0.0);
  }
  store_partial(local, node, nodes.count, part);
}
