// Adds the correction of the coarser level of a mesh, x + P e. The including kernel binds `vectors` and `taps`. Held nodes take it too:
// their blocks are 0, so that nothing sees it. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/mesh_level.wgsl"

fn prolong_node(fine : Level, coarse : Level, node : u32) {
  var x = vectors[vector_at(fine, kFirst, node)].xyz;
  if (coarse.node_count > 0u) {
    let first = coarse.first_taps + kTaps * node;
    for (var k = first; k < first + kTaps; k++) { x += taps[k].weight * vectors[vector_at(coarse, kSecond, taps[k].index)].xyz; }
  }
  vectors[vector_at(fine, kSecond, node)] = vec4f(x, 0.0);
}
