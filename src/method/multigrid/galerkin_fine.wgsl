// The matrix of the first coarse level, Pᵀ A P of masses and springs, and the inverse of its diagonal. One invocation
// per coarse node: it gathers the springs about its nine fine nodes. Bend springs count as structural ones that are
// stiffer by twice their stiffness each: exact where both springs that they span have the same stretch. Source:
// docs/solvers/multigrid.md, equation 10.
#include "gpu/index.wgsl"
#include "method/multigrid/air_block.wgsl"
#include "method/multigrid/fine_bindings.wgsl"
#include "method/multigrid/grid_springs.wgsl"
#include "method/multigrid/grid_store_block.wgsl"
#include "method/multigrid/grid_transfer.wgsl"
#include "method/multigrid/level_start.wgsl"
#include "method/multigrid/hold.wgsl"
//                                                                                 elements
@group(0) @binding(7) var<storage, read_write> operators : array<vec2f>;        // method/multigrid/grid_block.wgsl
var<private> blocks : array<Symmetric, 5>;
var<private> rate : f32;  // 1/s

// Weights of a place along a side, from coarse node I (x), from I + 1 (y) and from I - 1 (z).
fn line_taps(at : i32, center : i32, coarse : i32, n : i32, m : i32, regular : bool) -> vec3f {
  if (regular) {  // the same, where no end of the side is near
    let o = 0.5 * f32(at - center);
    return max(vec3f(0.0), 1.0 - abs(vec3f(o, o - 1.0, o + 1.0)));
  }
  return vec3f(tap(at, coarse, n, m), tap(at, coarse + 1, n, m), tap(at, coarse - 1, n, m));
}
fn is_regular(center : i32, n : i32, m : i32) -> bool { return n != m && center > 3 && center + 4 < n; }

fn node_at(x : i32, y : i32) -> u32 { return u32(y) * grid.nx + u32(x); }
fn inertia_at(x : i32, y : i32) -> f32 { return place[among_all(levels[0], node_at(x, y))].w; }

// Weights of a fine node, from the coarse node (x) and its neighbours to the right (y), below (z), and beside that (w),
// and to the left of that.
struct Taps {
  right : vec4f,
  left : f32,
  node : u32,
  inertia : f32,  // N/m; 0: fixed
}

fn taps_at(x : i32, y : i32, column : vec3f, row : vec3f) -> Taps {
  let inertia = inertia_at(x, y);
  if (inertia == 0.0) { return Taps(vec4f(0.0), 0.0, node_at(x, y), 0.0); }
  return Taps(vec4f(column.xy * row.x, column.xy * row.y), column.z * row.y, node_at(x, y), inertia);
}

fn add(matrix : Symmetric, own : f32, right : vec4f, left : f32) {
  let part = scaled(own, matrix);
  blocks[0] = sum_of(blocks[0], scaled(right.x, part));
  blocks[1] = sum_of(blocks[1], scaled(right.y, part));
  blocks[2] = sum_of(blocks[2], scaled(right.z, part));
  blocks[3] = sum_of(blocks[3], scaled(right.w, part));
  blocks[4] = sum_of(blocks[4], scaled(left, part));
}

// A spring from a to b.
fn add_spring(a : Taps, b : Taps, number : u32, law : SpringLaw, damping : f32) {
  let right = b.right - a.right;
  if (right.x == 0.0 || law.stiffness == 0.0) { return; }
  let s = spring_block(unpacked_pose(springs[spring_at(levels[0], a.node, number)]), law, rate * damping);
  add(sum_of(outer(s.direction, s.along), identity(s.across)), right.x, right, b.left - a.left);
}

// A structural spring from node `at` of a line to the next, with the bend springs above it.
fn add_structural(a : Taps, b : Taps, number : u32, rest_length : f32, longest : f32, at : i32, side : i32,
                  weight : f32) {
  let above = 2.0 * weight * (select(0.0, 1.0, at > 0) + select(0.0, 1.0, at + 2 < side));
  let bend = grid.stiffness.z;
  let damping = weight * grid.damping.x + above * grid.damping.z;
  var law = law_of(rest_length, longest, weight * grid.stiffness.x);
  law.stiffness += above * bend;
  add_spring(a, b, number, law, damping);
}

// Second differences of the fine grid that name a fixed node: coarse levels know of none, so these are not in their own
// bending. Where the middle node is fixed, |a + b|² <= 2 |a|² + 2 |b|² takes the others apart.
fn add_fixed_bend(coarse : vec2i, coarse_sides : vec2i, at : vec2i, along : vec2i, stiffness : f32) {
  let sides = vec2i(vec2u(grid.nx, grid.ny));
  let before = at - along;
  let behind = at + along;
  if (stiffness == 0.0 || any(before < vec2i(0)) || any(behind >= sides)) { return; }
  let fixed_before = inertia_at(before.x, before.y) == 0.0;
  let fixed_at = inertia_at(at.x, at.y) == 0.0;
  let fixed_behind = inertia_at(behind.x, behind.y) == 0.0;
  if (!(fixed_before || fixed_at || fixed_behind)) { return; }
  let a = taps_of_node(coarse, coarse_sides, before);
  let b = taps_of_node(coarse, coarse_sides, behind);
  if (fixed_at && !fixed_before && !fixed_behind) {
    add(identity(2.0 * stiffness), a.right.x, a.right, a.left);
    add(identity(2.0 * stiffness), b.right.x, b.right, b.left);
    return;
  }
  let m = taps_of_node(coarse, coarse_sides, at);
  let right = a.right - 2.0 * m.right + b.right;
  add(identity(stiffness), right.x, right, a.left - 2.0 * m.left + b.left);
}
fn taps_of_node(coarse : vec2i, coarse_sides : vec2i, at : vec2i) -> Taps {
  let sides = vec2i(vec2u(grid.nx, grid.ny));
  return taps_at(at.x, at.y, line_taps(at.x, 0, coarse.x, sides.x, coarse_sides.x, false),
                 line_taps(at.y, 0, coarse.y, sides.y, coarse_sides.y, false));
}

@compute @workgroup_size(kWorkgroupSize)
fn galerkin_fine(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let coarse = levels[1];
  let node = flat_index(id);
  if (node >= coarse.nx * coarse.ny) { return; }
  let coarse_j = node / coarse.nx;
  let coarse_i = node - coarse_j * coarse.nx;
  let i = i32(coarse_i);
  let j = i32(coarse_j);
  let nx = i32(grid.nx);
  let ny = i32(grid.ny);
  let mx = i32(coarse.nx);
  let my = i32(coarse.ny);
  let center_i = i32(center_of(coarse_i, grid.nx, coarse.nx));
  let center_j = i32(center_of(coarse_j, grid.ny, coarse.ny));
  let regular_i = is_regular(center_i, nx, mx);
  let regular_j = is_regular(center_j, ny, my);
  rate = 1.0 / formula_of(step.time.step_ratio).he;
  blocks = array<Symmetric, 5>();
  let shear = law_of(grid.rest_length.z, 0.0, grid.stiffness.y);
  let left = max(center_i - 2, 0);
  for (var y = max(center_j - 2, 0); y <= min(center_j + 2, ny - 1); y++) {
    let row_weight = line_weight(grid, u32(y), grid.ny);
    let down = y + 1 < ny;
    let row = line_taps(y, center_j, j, ny, my, regular_j);
    let below_row = line_taps(y + 1, center_j, j, ny, my, regular_j);
    // A window of four nodes goes along the row: a and b in it, and those below.
    var b = taps_at(left, y, line_taps(left, center_i, i, nx, mx, regular_i), row);
    var below_a = b;
    var below_b = b;
    if (down) {
      below_b = taps_at(left, y + 1, line_taps(left, center_i, i, nx, mx, regular_i), below_row);
      if (left > 0) {
        below_a = taps_at(left - 1, y + 1, line_taps(left - 1, center_i, i, nx, mx, regular_i), below_row);
      }
    }
    for (var x = left; x <= min(center_i + 2, nx - 1); x++) {
      let a = b;
      let before = below_a;
      below_a = below_b;
      var own = identity(a.inertia);
      if (kAirPushes) { own = sum_of(own, air_block(levels[0], a.node)); }
      if (kHolds) { own = sum_of(own, hold_block(among_all(levels[0], a.node))); }
      add(own, a.right.x, a.right, a.left);
      let rim_i = select(1.0, levels[0].rim, on_rim(u32(y), grid.ny));
      let rim_j = select(1.0, levels[0].rim, on_rim(u32(x), grid.nx));
      add_fixed_bend(vec2i(i, j), vec2i(mx, my), vec2i(x, y), vec2i(1, 0), rim_i * levels[0].bending_i);
      add_fixed_bend(vec2i(i, j), vec2i(mx, my), vec2i(x, y), vec2i(0, 1), rim_j * levels[0].bending_j);
      if (x + 1 < nx) {
        let column = line_taps(x + 1, center_i, i, nx, mx, regular_i);
        b = taps_at(x + 1, y, column, row);
        add_structural(a, b, kRight, grid.rest_length.x, grid.longest.x, x, nx, row_weight);
        if (down) {
          below_b = taps_at(x + 1, y + 1, column, below_row);
          add_spring(a, below_b, kDownRight, shear, grid.damping.y);
        }
      }
      if (down) {
        let weight = line_weight(grid, u32(x), grid.nx);
        add_structural(a, below_a, kDown, grid.rest_length.y, grid.longest.y, y, ny, weight);
        if (x > 0) { add_spring(a, before, kDownLeft, shear, grid.damping.y); }
      }
    }
  }
  store_block(coarse, node, 0u, blocks[0]);
  store_block(coarse, node, 1u, blocks[1]);
  store_block(coarse, node, 2u, blocks[2]);
  store_block(coarse, node, 3u, blocks[3]);
  store_block(coarse, node, 4u, blocks[4]);
  store_inverse(coarse, node, inverse(sum_of(blocks[0], identity(bending_diagonal(coarse, coarse_i, coarse_j)))));
}
