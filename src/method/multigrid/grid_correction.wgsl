// Adds the correction of the coarser level of a grid, x += P e. The including kernel binds `vectors`, and has e,
// solution_at(level, node), and keep_vector. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/grid_level.wgsl"

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
  return 0.25 * (solution_at(coarse, tj.x * coarse.nx + ti.x) + solution_at(coarse, tj.x * coarse.nx + ti.y) +
                 solution_at(coarse, tj.y * coarse.nx + ti.x) + solution_at(coarse, tj.y * coarse.nx + ti.y));
}

// x += P e
fn correct_node(fine : Level, coarse : Level, node : u32) {
  let x = vectors[vector_at(fine, kFirst, node)].xyz;
  keep_vector(fine, kFirst, node, x + correction(fine, coarse, node));
}
