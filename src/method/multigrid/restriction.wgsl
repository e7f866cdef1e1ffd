// The task of a coarse level, Pᵀ of what smoothing has left on the finer one, and its first step of smoothing. The including kernel
// binds `vectors`. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/transfer.wgsl"

fn restrict_node(fine : Level, coarse : Level, node : u32) {
  let j = node / coarse.nx;
  let i = node - j * coarse.nx;
  let center_i = center_of(i, fine.nx, coarse.nx);
  let center_j = center_of(j, fine.ny, coarse.ny);
  let column = taps_about(i32(center_i), i32(i), i32(fine.nx), i32(coarse.nx));
  let row = taps_about(i32(center_j), i32(j), i32(fine.ny), i32(coarse.ny));
  let x = vec3u(max(center_i, 1u) - 1u, center_i, min(center_i + 1u, fine.nx - 1u));
  let y = fine.nx * vec3u(max(center_j, 1u) - 1u, center_j, min(center_j + 1u, fine.ny - 1u));
  let left = vector_at(fine, kDirection, 0u);
  let sum = row.x * restrict_row(left + y.x, x, column) + row.y * restrict_row(left + y.y, x, column) +
            row.z * restrict_row(left + y.z, x, column);
  vectors[vector_at(coarse, kResidual, node)] = vec4f(sum, 0.0);
  vectors[vector_at(coarse, kDirection, node)] = vec4f(kBegin * times(inverse_at(coarse, node), sum), 0.0);
}

fn restrict_row(first : u32, x : vec3u, column : vec3f) -> vec3f {
  return column.x * vectors[first + x.x].xyz + column.y * vectors[first + x.y].xyz + column.z * vectors[first + x.z].xyz;
}
