// The last smoothing sweep of a V-cycle, on the finest level, and r·z of what the cycle has made of the residual, for
// one node. The including kernel binds `partials`, and has what smoothing.wgsl needs.
// Source: docs/solvers/multigrid.md, equations 8 and 14.
#include "method/multigrid/partial_sums.wgsl"
#include "method/multigrid/smoothing.wgsl"

fn end_cycle(level : Level, local : u32, node : u32) {
  var part = 0.0;
  let is_idle = node >= node_count(level) || is_solved();
  share_product(level, kSecond, node, local, is_idle);
  if (!is_idle && local % kLanes == 0u) {
    end_smoothing(level, kSecond, kFirst, node);
    part = dot(vectors[vector_at(level, kResidual, node)].xyz, vectors[vector_at(level, kFirst, node)].xyz);
  }
  store_partial(local, kLanes, node, node_count(level), vec2f(part, 0.0));
}
