// Goes along p: the solution, the residual and its norm, and the first smoothing sweep of the next cycle. One
// invocation per node. Source: docs/solvers/multigrid.md, equations 8 and 14.
#include "method/multigrid/fine_vectors.wgsl"
#include "method/multigrid/norm_scale.wgsl"
//                                                                                elements
@group(0) @binding(3) var<storage, read>       scales   : array<f32>;        // norm_scale.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn advance(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = id.z;
  let node = flat_index(id);
  let level = finest();
  let state = solve_state();
  var part = 0.0;
  if (node < nodes.count && !state.done) {
    let p = vectors[vector_at(level, this_search(state), node)].xyz;
    let r = vectors[vector_at(level, kResidual, node)].xyz -
            state.rate * vectors[vector_at(level, kProduct, node)].xyz;
    let d = times(inverse_at(level, node), r);
    vectors[vector_at(level, kSolution, node)] += vec4f(state.rate * p, 0.0);
    vectors[vector_at(level, kResidual, node)] = vec4f(r, 0.0);
    vectors[vector_at(level, kDirection, node)] = vec4f(kBegin * d, 0.0);
    part = norm_scale(node) * dot(r, d);
  }
  store_partial(local, 1u, node, nodes.count, vec2f(part, 0.0));
}
