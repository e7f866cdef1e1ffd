// The task of a coarse level, Pᵀ of what smoothing has left on the finer one, and its first step of smoothing. The including kernel
// binds `vectors`. Source: docs/solvers/multigrid.md, equation 7.
#include "multigrid/chebyshev.wgsl"
#include "multigrid/transfer.wgsl"

fn restrict_node(fine : Level, coarse : Level, node : u32) {
  let j = node / coarse.nx;
  let i = node - j * coarse.nx;
  let center_i = center_of(i, fine.nx, coarse.nx);
  let center_j = center_of(j, fine.ny, coarse.ny);
  let left = vector_at(fine, kDirection, 0u);
  var sum = vec3f(0.0);
  for (var y = max(center_j, 1u) - 1u; y <= min(center_j + 1u, fine.ny - 1u); y++) {
    let row = tap(i32(y), i32(j), i32(fine.ny), i32(coarse.ny));
    for (var x = max(center_i, 1u) - 1u; x <= min(center_i + 1u, fine.nx - 1u); x++) {
      sum += row * tap(i32(x), i32(i), i32(fine.nx), i32(coarse.nx)) * vectors[left + y * fine.nx + x].xyz;
    }
  }
  vectors[vector_at(coarse, kResidual, node)] = vec4f(sum, 0.0);
  vectors[vector_at(coarse, kDirection, node)] = vec4f(kBegin * times(inverse_at(coarse, node), sum), 0.0);
}
