// Adds the correction of the coarser level of a mesh, x += P e. The including kernel binds `vectors` and `taps`. Fixed
// nodes take it too: their blocks are 0, so that nothing sees it. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/mesh_level.wgsl"

fn correct_node(fine : Level, coarse : Level, node : u32) {
  let at = vector_at(fine, kFirst, node);
  var x = vectors[at].xyz;
  let first = coarse.first_taps + kTaps * node;
  for (var k = first; k < first + kTaps; k++) {
    x += taps[k].weight * vectors[vector_at(coarse, kFirst, taps[k].index)].xyz;
  }
  vectors[at] = vec4f(x, 0.0);
}
