// The matrix of a coarse level of a grid from that of the finer one, Pᵀ A P, and the inverse of its diagonal. One
// invocation per coarse node and block. Source: docs/solvers/multigrid.md, equation 10.
//
// P is a product of one factor along i and one along j, and so are the pairs (a, b) of fine nodes that a block of the
// product sums: a of the coarse node and b of its neighbour, no more than one apart. Along a side, with 0 where the
// coarse node lies, they are
//   for the coarse node itself: (-1, -1), (0, 0), (1, 1), (-1, 0), (0, 1), (0, -1), (1, 0)
//   for its neighbour to s:     (0, s), (s, s), (s, 2 s)
// Those of a row are read at once, without branches; missing ones count 0.
#include "gpu/index.wgsl"
#include "method/multigrid/grid_store_block.wgsl"
#include "method/multigrid/grid_transfer.wgsl"
#include "method/multigrid/level_start.wgsl"
//                                                                                 elements
@group(0) @binding(0) var<uniform>             levels    : array<GridLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read_write> operators : array<vec2f>;        // method/multigrid/grid_block.wgsl
var<private> center : vec2i;  // the fine node on which the coarse one lies
var<private> gathered : Symmetric;

// The weights of fine nodes of a side: `own` of the coarse node at -1, 0 and 1, `next` of its neighbour to `side` at
// `side` and 2 `side`.
struct Pairs { side : i32, own : vec3f, next : vec2f }

fn pairs_of(c : i32, coarse : i32, side : i32, n : i32, m : i32) -> Pairs {
  let next = vec2f(inside_tap(c + side, coarse + side, n, m), inside_tap(c + 2 * side, coarse + side, n, m));
  return Pairs(side, taps_about(c, coarse, n, m), next);
}
fn own_tap(pairs : Pairs, at : i32) -> f32 {
  return select(select(pairs.own.y, pairs.own.x, at < 0), pairs.own.z, at > 0);
}

// Adds the block of the row of the node at (x, y) from `center` and the column of its neighbour (dx, dy) away.
fn add(fine : Level, weight : f32, x : i32, y : i32, dx : i32, dy : i32) {
  let stored = dy > 0 || (dy == 0 && dx >= 0);
  let at = center + select(vec2i(x + dx, y + dy), vec2i(x, y), stored);
  let to = select(-dx, dx, stored);  // a block is its own transpose: the one back is the one to there
  let inside = vec2u(clamp(at, vec2i(0), vec2i(i32(fine.nx), i32(fine.ny)) - 1));
  let number = select(select(4u, u32(2 + to), to >= 0), u32(to), dy == 0);
  gathered = sum_of(gathered, scaled(weight, block_at(fine, inside.y * fine.nx + inside.x, number)));
}

// Adds the pairs of row y and the one dy further.
fn add_row(fine : Level, weight : f32, columns : Pairs, y : i32, dy : i32) {
  let own = weight * columns.own;
  let side = columns.side;
  if (side != 0) {
    let beside = weight * own_tap(columns, side);
    add(fine, own.y * columns.next.x, 0, y, side, dy);
    add(fine, beside * columns.next.x, side, y, 0, dy);
    add(fine, beside * columns.next.y, side, y, side, dy);
    return;
  }
  let back = select(1.0, 0.0, dy == 0);  // within a row there and back are one block
  add(fine, own.x * columns.own.x, -1, y, 0, dy);
  add(fine, own.y * columns.own.y, 0, y, 0, dy);
  add(fine, own.z * columns.own.z, 1, y, 0, dy);
  add(fine, (2.0 - back) * own.x * columns.own.y, -1, y, 1, dy);
  add(fine, (2.0 - back) * own.y * columns.own.z, 0, y, 1, dy);
  add(fine, back * own.y * columns.own.x, 0, y, -1, dy);
  add(fine, back * own.z * columns.own.y, 1, y, -1, dy);
}

// One of the five blocks of a coarse node.
fn coarsen(fine : Level, coarse : Level, node : u32, number : u32) {
  let j = node / coarse.nx;
  let i = node - j * coarse.nx;
  center = vec2i(vec2u(center_of(i, fine.nx, coarse.nx), center_of(j, fine.ny, coarse.ny)));
  gathered = zero_matrix();
  let right = select(select(0, 1, number == 1u || number == 3u), -1, number == 4u);
  let down = select(0, 1, number >= 2u);
  let columns = pairs_of(center.x, i32(i), right, i32(fine.nx), i32(coarse.nx));
  let rows = pairs_of(center.y, i32(j), down, i32(fine.ny), i32(coarse.ny));
  let first = select(-1, 0, number == 0u);  // the same for rows
  for (var y = down - 1; y <= 1; y++) {
    for (var dy = max(first, 2 * down - 1 - y); dy <= min(1, 2 * down + 1 - y); dy++) {
      let other = select(own_tap(rows, y + dy), select(rows.next.x, rows.next.y, y + dy == 2), down == 1);
      add_row(fine, select(1.0, 2.0, number == 0u && dy == 1) * own_tap(rows, y) * other, columns, y, dy);
    }
  }
  store_block(coarse, node, number, gathered);
  if (number == 0u) {
    store_inverse(coarse, node, inverse(sum_of(gathered, identity(bending_diagonal(coarse, i, j)))));
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn galerkin(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let count = node_count(levels[1]);
  let index = flat_index(id);
  if (index < kBlocks * count) { coarsen(levels[0], levels[1], index % count, index / count); }
}
