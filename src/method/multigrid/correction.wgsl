// What the coarser level's solution is at a node, P e. The including kernel binds `vectors`. Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/transfer.wgsl"

fn correction(fine : Level, coarse : Level, i : u32, j : u32) -> vec3f {
  let ti = taps_of(i, fine.nx, coarse.nx);
  let tj = taps_of(j, fine.ny, coarse.ny);
  let first = vector_at(coarse, kFirst, 0u);
  return 0.25 * (vectors[first + tj.x * coarse.nx + ti.x].xyz + vectors[first + tj.x * coarse.nx + ti.y].xyz +
                 vectors[first + tj.y * coarse.nx + ti.x].xyz + vectors[first + tj.y * coarse.nx + ti.y].xyz);
}

// x += P e
fn correct_node(fine : Level, coarse : Level, node : u32) {
  let j = node / fine.nx;
  let at = vector_at(fine, kFirst, node);
  vectors[at] = vec4f(vectors[at].xyz + correction(fine, coarse, node - j * fine.nx, j), 0.0);
}
