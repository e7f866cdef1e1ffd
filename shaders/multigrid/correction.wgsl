// What the coarser level's solution is at a node, P e. The including kernel binds `vectors`.
#include "multigrid/transfer.wgsl"

fn correction(fine : Level, coarse : Level, i : u32, j : u32) -> vec3f {
  if (coarse.nx == 0u) { return vec3f(0.0); }
  let ti = taps_of(i, fine.nx, coarse.nx);
  let tj = taps_of(j, fine.ny, coarse.ny);
  let first = vector_at(coarse, kFirst, 0u);
  return 0.25 * (vectors[first + tj.x * coarse.nx + ti.x].xyz + vectors[first + tj.x * coarse.nx + ti.y].xyz +
                 vectors[first + tj.y * coarse.nx + ti.x].xyz + vectors[first + tj.y * coarse.nx + ti.y].xyz);
}
