// Pᵀ of the residual after smoothing on a level of a mesh, and the first smoothing sweep on the coarser one. The
// including kernel binds `vectors`, `source_starts` and `sources`, and has that residual, left_at(level, node).
// Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/level_start.wgsl"
#include "method/multigrid/mesh_level.wgsl"

fn restrict_node(fine : Level, coarse : Level, node : u32) {
  let list = coarse.first_source + node;
  let end = source_starts[list + 1u];
  var sum = vec3f(0.0);
  for (var k = source_starts[list]; k < end; k += 4u) {  // each waits for memory, so four at a time
    let a = sources[k];
    let b = sources[min(k + 1u, end - 1u)];
    let c = sources[min(k + 2u, end - 1u)];
    let d = sources[min(k + 3u, end - 1u)];
    let of_a = left_at(fine, a.index);
    let of_b = left_at(fine, b.index);
    let of_c = left_at(fine, c.index);
    let of_d = left_at(fine, d.index);
    sum += a.weight * of_a;
    sum += select(0.0, b.weight, k + 1u < end) * of_b;
    sum += select(0.0, c.weight, k + 2u < end) * of_c;
    sum += select(0.0, d.weight, k + 3u < end) * of_d;
  }
  start_level(coarse, node, sum, inverse_at(coarse, node));
}
