// Where a node's own part of what the substep minimises is least, its neighbours where they are, of the ways that
// obstacles allow. The including kernel binds `step`, and `aim` to read and write.
// Source: docs/solvers/vbd.md, equations 3 and 7.
#include "method/holds/held_way.wgsl"

fn descended(node : u32, from_way : vec3f, hessian : Symmetric, slope : vec3f) -> vec3f {
  let compliance = inverse(hessian);
  let free = from_way + times(compliance, slope);
  if (!kHolds) { return free; }
  return held_way(node, free, hessian, compliance);
}
