// Adds the correction of the coarser level of a mesh, x += P e. The including kernel binds `vectors` and `taps`, and
// has e, solution_at(level, node), and keep_vector. Fixed nodes take it too: their blocks are 0, so that nothing sees
// it. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/mesh_level.wgsl"

fn correct_node(fine : Level, coarse : Level, node : u32) {
  var x = vectors[vector_at(fine, kFirst, node)].xyz;
  let first = coarse.first_taps + kTaps * node;
  for (var k = first; k < first + kTaps; k++) {
    x += taps[k].weight * solution_at(coarse, taps[k].index);
  }
  keep_vector(fine, kFirst, node, x);
}
