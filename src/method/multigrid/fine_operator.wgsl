// A x on the finest level, where A is not stored: each spring's block is made anew from where its nodes are. The including kernel binds
// `step`, `grid`, `place` and `holds`, and has the field, operand(level, node).
#include "method/multigrid/bending.wgsl"
#include "method/multigrid/hold.wgsl"
#include "method/multigrid/springs_of_node.wgsl"
var<private> here : vec3f;   // of the node whose springs are summed
var<private> value : vec3f;
var<private> rate : f32;     // 1/s: what a displacement is as a velocity
var<private> finest : Level;

fn pull(neighbour : u32, rest_length : f32, stiffness : f32, damping : f32) -> vec3f {
  let hessian = spring_block(place[neighbour].xyz - here, rest_length, stiffness, rate * damping);
  return block_times(hessian, value - operand(finest, neighbour));
}

fn fine_product(level : Level, i : u32, j : u32, node : u32) -> vec3f {
  let own = place[node];
  here = own.xyz;
  value = operand(level, node);
  rate = 1.0 / formula_of(step.step_ratio).he;
  finest = level;
  let product = own.w * value + sum_of_springs(grid, i, j, node) + bending_product(level, i, j, node);
  if (!kHolds) { return product; }
  return product + hold_product(node, value);
}
