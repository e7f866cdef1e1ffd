// Pᵀ of a level's residual after smoothing, for one node of the coarser level of a grid. The including kernel binds
// `vectors` and has that residual, left_at(level, node). Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/grid_transfer.wgsl"
#include "method/multigrid/level_start.wgsl"

fn restrict_row(fine : Level, row : u32, x : vec3u, column : vec3f) -> vec3f {
  return column.x * left_at(fine, row + x.x) + column.y * left_at(fine, row + x.y) +
         column.z * left_at(fine, row + x.z);
}

// Also the first smoothing sweep on the coarser level. Taps outside the grid weigh 0, and read a node that is inside.
fn restrict_node(fine : Level, coarse : Level, node : u32) {
  let j = node / coarse.nx;
  let i = node - j * coarse.nx;
  let center_i = center_of(i, fine.nx, coarse.nx);
  let center_j = center_of(j, fine.ny, coarse.ny);
  let column = taps_about(i32(center_i), i32(i), i32(fine.nx), i32(coarse.nx));
  let row = taps_about(i32(center_j), i32(j), i32(fine.ny), i32(coarse.ny));
  let x = vec3u(max(center_i, 1u) - 1u, center_i, min(center_i + 1u, fine.nx - 1u));
  let y = fine.nx * vec3u(max(center_j, 1u) - 1u, center_j, min(center_j + 1u, fine.ny - 1u));
  let sum = row.x * restrict_row(fine, y.x, x, column) + row.y * restrict_row(fine, y.y, x, column) +
            row.z * restrict_row(fine, y.z, x, column);
  start_level(coarse, node, sum, inverse_at(coarse, node));
}
