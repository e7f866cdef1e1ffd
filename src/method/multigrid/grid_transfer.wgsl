// From one level of a grid to the next, P and Pᵀ: coarse node I coincides with fine node 2 I, the last with the last;
// fine nodes between take the mean. A side that is not halved stays as it is. The including kernel binds `vectors`.
// Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/grid_level.wgsl"
#include "method/multigrid/level_start.wgsl"

// How much fine node `fine` takes from coarse node `coarse`, along a side of n fine and m coarse nodes.
fn tap(fine : i32, coarse : i32, n : i32, m : i32) -> f32 {
  let apart = abs(fine - min(2 * coarse, n - 1));
  let beside = select(0.0, 0.5, (apart == 1) & ((fine & 1) == 1) & (fine + 1 != n));
  let halved = select(beside, 1.0, apart == 0);
  let kept = select(0.0, 1.0, fine == coarse);
  return select(0.0, select(halved, kept, n == m), (coarse >= 0) & (coarse < m));
}

// The weights of it in fine nodes at `center` - 1, `center` and `center` + 1; 0 where there is no such node.
fn taps_about(center : i32, coarse : i32, n : i32, m : i32) -> vec3f {
  return vec3f(inside_tap(center - 1, coarse, n, m), inside_tap(center, coarse, n, m),
               inside_tap(center + 1, coarse, n, m));
}
fn inside_tap(fine : i32, coarse : i32, n : i32, m : i32) -> f32 {
  return select(0.0, tap(fine, coarse, n, m), fine >= 0 && fine < n);
}

// The fine node on which a coarse one lies.
fn center_of(coarse : u32, n : u32, m : u32) -> u32 { return select(min(2u * coarse, n - 1u), coarse, n == m); }

// The coarse nodes that a fine one takes from, the same twice where it is one.
fn taps_of(fine : u32, n : u32, m : u32) -> vec2u {
  let halved = select(vec2u(fine / 2u, (fine + 1u) / 2u), vec2u(m - 1u), fine + 1u == n);
  return select(halved, vec2u(fine), n == m);
}

// P e: the coarser level's solution at a node.
fn correction(fine : Level, coarse : Level, node : u32) -> vec3f {
  let j = node / fine.nx;
  let ti = taps_of(node - j * fine.nx, fine.nx, coarse.nx);
  let tj = taps_of(j, fine.ny, coarse.ny);
  let first = vector_at(coarse, kFirst, 0u);
  return 0.25 * (vectors[first + tj.x * coarse.nx + ti.x].xyz + vectors[first + tj.x * coarse.nx + ti.y].xyz +
                 vectors[first + tj.y * coarse.nx + ti.x].xyz + vectors[first + tj.y * coarse.nx + ti.y].xyz);
}

// x += P e
fn correct_node(fine : Level, coarse : Level, node : u32) {
  let at = vector_at(fine, kFirst, node);
  vectors[at] = vec4f(vectors[at].xyz + correction(fine, coarse, node), 0.0);
}

fn restrict_row(first : u32, x : vec3u, column : vec3f) -> vec3f {
  return column.x * vectors[first + x.x].xyz + column.y * vectors[first + x.y].xyz +
         column.z * vectors[first + x.z].xyz;
}

// Pᵀ of the finer level's residual after smoothing, and the first smoothing sweep on the coarser one.
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
  start_level(coarse, node, sum, inverse_at(coarse, node));
}
