// Chebyshev's polynomial of D⁻¹ A. By default that of coarse levels, of degree 2, for eigenvalues from an eighth of the
// largest up to it; kernels of the finest level are given their own. The including kernel binds `vectors` and has the
// Level. Mirror: src/method/multigrid/smoothing.hpp. Source: docs/solvers/multigrid.md.
#include "method/symmetric.wgsl"
const kHigh = 2.9;
const kMiddle = kHigh * (1.0 + 1.0 / 8.0) / 2.0;
const kHalf = kHigh * (1.0 - 1.0 / 8.0) / 2.0;
const kSigma = kMiddle / kHalf;
const kRho = 1.0 / (2.0 * kSigma - 1.0 / kSigma);
override kKeep : f32 = kRho / kSigma;       // in a sweep behind the first: of the direction of the one before
override kTake : f32 = 2.0 * kRho / kHalf;  // and of D⁻¹ (r - A x)
override kBegin : f32 = 1.0 / kMiddle;      // in the first: of D⁻¹ r

fn inverse_at(level : Level, node : u32) -> Symmetric {
  let a = vectors[vector_at(level, kInverse, node)];
  let b = vectors[vector_at(level, kInverse + 1u, node)];
  return Symmetric(a.xyz, vec3f(a.w, b.xy));
}
