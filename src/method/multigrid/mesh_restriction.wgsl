// The task of a coarse level of a mesh, Pᵀ of what smoothing has left on the finer one, and its first step of smoothing. The including
// kernel binds `vectors`, `source_starts` and `sources`. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/symmetric.wgsl"

fn restrict_node(fine : Level, coarse : Level, node : u32) {
  let list = coarse.first_source + node;
  var sum = vec3f(0.0);
  for (var k = source_starts[list]; k < source_starts[list + 1u]; k++) {
    let source = sources[k];
    sum += source.weight * vectors[vector_at(fine, kDirection, source.index)].xyz;
  }
  vectors[vector_at(coarse, kResidual, node)] = vec4f(sum, 0.0);
  vectors[vector_at(coarse, kDirection, node)] = vec4f(kBegin * times(inverse_at(coarse, node), sum), 0.0);
}
