// Keeps the inverse of a diagonal block for smoothing. The including kernel binds `vectors` and has the Level.
#include "method/multigrid/symmetric.wgsl"

fn store_inverse(level : Level, node : u32, inverted : Symmetric) {
  vectors[vector_at(level, kInverse, node)] = vec4f(inverted.diagonal, inverted.mixed.x);
  vectors[vector_at(level, kInverse + 1u, node)] = vec4f(inverted.mixed.yz, 0.0, 0.0);
}
