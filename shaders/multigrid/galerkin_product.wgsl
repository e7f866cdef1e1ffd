// The matrix of a coarse level from that of the finer one, Pᵀ A P, and the inverse of its diagonal. The including kernel binds `vectors`
// and `operators`. Source: docs/solvers/multigrid.md, equation 10.
#include "multigrid/bending_diagonal.wgsl"
#include "multigrid/coarse_block.wgsl"
#include "multigrid/store_blocks.wgsl"
#include "multigrid/store_inverse.wgsl"
#include "multigrid/transfer.wgsl"
var<private> blocks : array<Symmetric, 5>;

fn block_number(di : i32, dj : i32) -> u32 {
  if (dj == 0) { return u32(di); }
  return select(u32(2 + di), 4u, di < 0);
}

// The block of the row of node a and the column of its neighbour (di, dj) away.
fn neighbour_block(level : Level, a : u32, di : i32, dj : i32) -> Symmetric {
  if (dj > 0 || (dj == 0 && di >= 0)) { return block_at(level, a, block_number(di, dj)); }
  return block_at(level, u32(i32(a) + dj * i32(level.nx) + di), block_number(-di, -dj));
}

fn coarsen(fine : Level, coarse : Level, node : u32) {
  let j = node / coarse.nx;
  let i = node - j * coarse.nx;
  let coarse_i = i32(i);
  let coarse_j = i32(j);
  let nx = i32(fine.nx);
  let ny = i32(fine.ny);
  let mx = i32(coarse.nx);
  let my = i32(coarse.ny);
  let center_i = i32(center_of(i, fine.nx, coarse.nx));
  let center_j = i32(center_of(j, fine.ny, coarse.ny));
  for (var k = 0u; k < kBlocks; k++) { blocks[k] = zero_matrix(); }
  for (var y = max(center_j - 1, 0); y <= min(center_j + 1, ny - 1); y++) {
    for (var x = max(center_i - 1, 0); x <= min(center_i + 1, nx - 1); x++) {
      let own = tap(x, coarse_i, nx, mx) * tap(y, coarse_j, ny, my);
      if (own == 0.0) { continue; }
      let a = u32(y * nx + x);
      for (var dj = max(-1, -y); dj <= min(1, ny - 1 - y); dj++) {
        let row = tap(y + dj, coarse_j, ny, my);
        let below = tap(y + dj, coarse_j + 1, ny, my);
        for (var di = max(-1, -x); di <= min(1, nx - 1 - x); di++) {
          let here = tap(x + di, coarse_i, nx, mx);
          let right = tap(x + di, coarse_i + 1, nx, mx);
          let left = tap(x + di, coarse_i - 1, nx, mx);
          let part = scaled(own, neighbour_block(fine, a, di, dj));
          blocks[0] = sum_of(blocks[0], scaled(here * row, part));
          blocks[1] = sum_of(blocks[1], scaled(right * row, part));
          blocks[2] = sum_of(blocks[2], scaled(here * below, part));
          blocks[3] = sum_of(blocks[3], scaled(right * below, part));
          blocks[4] = sum_of(blocks[4], scaled(left * below, part));
        }
      }
    }
  }
  store_blocks(coarse, node, blocks);
  store_inverse(coarse, node, inverse(sum_of(blocks[0], identity(bending_diagonal(coarse, i, j)))));
}
