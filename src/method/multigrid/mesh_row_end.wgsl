// The end of a row of a mesh's finest level: what obstacles add, its diagonal, the inverse of that, and the residual.
// The including kernel binds `step`, `nodes`, `holds`, `presses`, `vectors` and `blocks`.
#include "method/multigrid/air_block.wgsl"
#include "method/multigrid/hold_at_obstacles.wgsl"
#include "method/multigrid/level_start.wgsl"
#include "method/multigrid/mesh_inverse.wgsl"
#include "method/multigrid/mesh_store_block.wgsl"

// `inertia`: that of the node, N/m; 0: it is fixed, and has no unknown. `entry`: that of its own block.
fn end_row(level : Level, node : u32, inertia : f32, entry : u32, without : Symmetric, before : vec3f) {
  var diagonal = without;
  var residual = before;
  if (inertia == 0.0) {
    diagonal = zero_matrix();
    residual = vec3f(0.0);
    if (kHolds) { free_of_obstacles(node, nodes.first_vertex); }
  } else {
    if (kAirPushes) { diagonal = sum_of(diagonal, air_block(level, node)); }
    if (kHolds) {
      let hold = hold_at_obstacles(node, nodes.first_vertex, inertia, diagonal, residual,
                                   vectors[vector_at(level, kWay, node)]);
      residual += hold.force;
      diagonal = sum_of(diagonal, hold.block);
    }
  }
  store_symmetric(entry, diagonal);
  store_inverse(level, node, inverse_for_sweeps(diagonal));
  vectors[vector_at(level, kResidual, node)] = vec4f(residual, 0.0);
}
