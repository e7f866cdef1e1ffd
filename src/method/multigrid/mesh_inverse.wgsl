// The inverse of a diagonal block as smoothing and norms have it.
#include "method/symmetric.wgsl"
override kDiagonalPart : f32 = 1.0;  // mirror: kElementDiagonalPart, src/method/multigrid/bottom.hpp

fn inverse_for_sweeps(diagonal : Symmetric) -> Symmetric { return scaled(kDiagonalPart, inverse(diagonal)); }
