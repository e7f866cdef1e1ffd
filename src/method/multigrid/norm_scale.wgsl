// How much a node's part of a residual's norm counts: src/method/multigrid/bottom.hpp. The including kernel binds
// `scales`.
override kScales : bool = false;  // false: as all others
fn norm_scale(node : u32) -> f32 {
  if (kScales) { return scales[node]; }
  return 1.0;
}
