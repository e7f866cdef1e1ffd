// How far a step of the relaxation may take a node: the matrix of the step is a multiple of 1. The including kernel
// binds `step`, `cloth`, and `aim` to read and write. Source: docs/solvers/projective_dynamics.md, equations 4 and 4a.
#include "method/holds/held_way.wgsl"
#include "method/projective_dynamics/relaxed_nodes.wgsl"

fn allowed_change(node : u32, before : vec3f, change : vec3f, inverse_mass : f32) -> vec3f {
  if (!kHolds || inverse_mass == 0.0) { return change; }
  if (aim[hold_at(node) + 2u].y == kFree) { return change; }
  return held_way(node, before + change, identity(1.0), identity(1.0)) - before;
}
