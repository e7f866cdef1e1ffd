// A x on the finest level of a grid, where A is not stored: each spring's block is recomputed from the positions of its
// nodes. The including kernel binds `step`, `grid`, `place`, `holds` and `vectors`, and has operand(level, x, node).
#include "method/multigrid/air_block.wgsl"
#include "method/multigrid/bending.wgsl"
#include "method/multigrid/hold.wgsl"
#include "method/multigrid/spring.wgsl"
#include "element/spring/springs_of_node.wgsl"

struct Own {  // the node whose springs are summed
  place : vec3f,  // m
  value : vec3f,  // of x
  rate : f32,     // 1/s: velocity per displacement
  level : Level,
  x : u32,
}

fn pull(own : Own, other : u32, rest_length : f32, longest : f32, weight : f32, stiffness : f32,
        damping : f32) -> vec3f {
  if (stiffness == 0.0) { return vec3f(0.0); }
  let span = place[among_all(own.level, other)].xyz - own.place;
  let hessian = spring_block(span, law_of(rest_length, longest, weight * stiffness), own.rate * (weight * damping));
  return block_times(hessian, own.value - operand(own.level, own.x, other));
}

fn product(level : Level, x : u32, node : u32) -> vec3f {
  let j = node / level.nx;
  let i = node - j * level.nx;
  let here = place[among_all(level, node)];
  let own = Own(here.xyz, operand(level, x, node), 1.0 / formula_of(step.time.step_ratio).he, level, x);
  let springs = sum_of_springs(own, grid, node, grid.nx, i, j);
  var sum = here.w * own.value + springs + bending_product(level, x, i, j, node);
  if (kAirPushes) { sum += times(air_block(level, node), own.value); }
  if (!kHolds) { return sum; }
  return sum + hold_product(among_all(level, node), own.value);
}
