// A x on the finest level of a grid, where each spring's block follows from its pose. The including kernel binds
// `step`, `grid`, `place`, `holds`, `vectors` and `springs`, and has operand(level, x, node).
#include "method/multigrid/air_block.wgsl"
#include "method/multigrid/bending.wgsl"
#include "method/multigrid/grid_springs.wgsl"
#include "method/multigrid/hold.wgsl"
#include "element/spring/springs_of_node.wgsl"

struct Own {  // the node whose springs are summed
  node : u32,
  value : vec3f,  // of x
  rate : f32,     // 1/s: velocity per displacement
  level : Level,
  x : u32,
}

fn pull(own : Own, other : u32, number : u32, rest_length : f32, longest : f32, weight : f32, stiffness : f32,
        damping : f32) -> vec3f {
  if (stiffness == 0.0) { return vec3f(0.0); }
  let pose = unpacked_pose(springs[spring_at(own.level, min(own.node, other), number)]);
  let hessian = spring_block(pose, law_of(rest_length, longest, weight * stiffness), own.rate * (weight * damping));
  return block_times(hessian, own.value - operand(own.level, own.x, other));
}

fn product(level : Level, x : u32, node : u32) -> vec3f {
  let j = node / level.nx;
  let i = node - j * level.nx;
  let own = Own(node, operand(level, x, node), 1.0 / formula_of(step.time.step_ratio).he, level, x);
  let springs = sum_of_springs(own, grid, node, grid.nx, i, j);
  var sum = place[among_all(level, node)].w * own.value + springs + bending_product(level, x, i, j, node);
  if (kAirPushes) { sum += times(air_block(level, node), own.value); }
  if (!kHolds) { return sum; }
  return sum + hold_product(among_all(level, node), own.value);
}
