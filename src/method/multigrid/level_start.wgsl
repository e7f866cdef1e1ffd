// The start of a level: its residual, the inverse of its matrix's diagonal, the first smoothing sweep. The
// including kernel binds `vectors` and has the Level. Source: docs/solvers/multigrid.md, equation 8.
#include "method/multigrid/chebyshev.wgsl"

fn store_inverse(level : Level, node : u32, inverted : Symmetric) {
  vectors[vector_at(level, kInverse, node)] = vec4f(inverted.diagonal, inverted.mixed.x);
  vectors[vector_at(level, kInverse + 1u, node)] = vec4f(inverted.mixed.yz, 0.0, 0.0);
}

fn start_level(level : Level, node : u32, residual : vec3f, inverted : Symmetric) {
  vectors[vector_at(level, kResidual, node)] = vec4f(residual, 0.0);
  vectors[vector_at(level, kDirection, node)] = vec4f(kBegin * times(inverted, residual), 0.0);
}
