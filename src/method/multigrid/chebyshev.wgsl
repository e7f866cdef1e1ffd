// Chebyshev's polynomial of D⁻¹ A, of degree 2, for eigenvalues from an eighth of the largest up to it: 2 for springs,
// 8/3 for bending inside. The including kernel binds `vectors` and has the Level. Source: docs/solvers/multigrid.md.
#include "method/symmetric.wgsl"
const kHigh = 2.9;
const kMiddle = kHigh * (1.0 + 1.0 / 8.0) / 2.0;
const kHalf = kHigh * (1.0 - 1.0 / 8.0) / 2.0;
const kSigma = kMiddle / kHalf;
const kRho = 1.0 / (2.0 * kSigma - 1.0 / kSigma);
const kKeep = kRho / kSigma;      // of the first sweep's direction in the second
const kTake = 2.0 * kRho / kHalf; // of D⁻¹ (r - A x) in the second
const kBegin = 1.0 / kMiddle;     // of D⁻¹ r in the first

fn inverse_at(level : Level, node : u32) -> Symmetric {
  let a = vectors[vector_at(level, kInverse, node)];
  let b = vectors[vector_at(level, kInverse + 1u, node)];
  return Symmetric(a.xyz, vec3f(a.w, b.xy));
}
