// A smoothing sweep behind the first on a level of a mesh. kLanes invocations per node.
#include "method/multigrid/mesh_smoothing.wgsl"
override kFrom : u32;             // the vector of the solution before
override kTo : u32;               // and after
override kStep : u32;             // that of the direction of the sweep before
override kNext : u32;             // where its own one is kept
override kIsLast : bool = false;  // true: nothing is kept

@compute @workgroup_size(kWorkgroupSize)
fn mesh_smooth(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  let level = levels[0];
  let node = flat_index(id) / kLanes;
  let is_idle = node >= node_count(level) || is_solved();
  share_product(level, kFrom, node, local, is_idle);
  if (is_idle || local % kLanes != 0u) { return; }
  let d = sweep_of(level, kStep, kFrom, kKeep, kTake, node);
  keep_vector(level, kTo, node, operand(level, kFrom, node) + d);
  if (!kIsLast) { vectors[vector_at(level, kNext, node)] = vec4f(d, 0.0); }
}
