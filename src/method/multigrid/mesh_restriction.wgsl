// Pᵀ of the residual after smoothing on a level of a mesh, and the first smoothing sweep on the coarser one. The
// including kernel binds `vectors`, `source_starts` and `sources`. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/level_start.wgsl"
#include "method/multigrid/mesh_level.wgsl"

fn restrict_node(fine : Level, coarse : Level, node : u32) {
  let list = coarse.first_source + node;
  var sum = vec3f(0.0);
  for (var k = source_starts[list]; k < source_starts[list + 1u]; k++) {
    let source = sources[k];
    sum += source.weight * vectors[vector_at(fine, kDirection, source.index)].xyz;
  }
  start_level(coarse, node, sum, inverse_at(coarse, node));
}
