// A x on a level of a mesh, by kLanes invocations a node: a node of a coarse level has some twenty neighbours, and each
// of them waits for memory. The including kernel binds `vectors`, `blocks`, `row_starts` and `entries`, and has
// operand(level, x, node).
#include "method/multigrid/mesh_block.wgsl"
var<workgroup> lane_x : array<f32, kWorkgroupSize>;
var<workgroup> lane_y : array<f32, kWorkgroupSize>;
var<workgroup> lane_z : array<f32, kWorkgroupSize>;
var<private> first_lane : u32;

// Every kLanes-th of a row's terms.
fn lane_product(level : Level, x : u32, node : u32, lane : u32) -> vec3f {
  let row = level.first_row + node;
  let end = row_starts[row + 1u];
  var sum = vec3f(0.0);
  for (var a = row_starts[row] + lane; a < end; a += 2u * kLanes) {  // each waits for memory, so two at a time
    let b = select(a, a + kLanes, a + kLanes < end);
    let block_a = block_of(a);
    let block_b = block_of(b);
    let x_a = operand(level, x, entries[a]);
    let x_b = select(vec3f(0.0), operand(level, x, entries[b]), b != a);
    sum = sum + mesh_block_times(block_a, x_a) + mesh_block_times(block_b, x_b);
  }
  return sum;
}

// For all invocations of a workgroup at once, of which those without a node are idle. Then the first lane of a node has
// the product, until the workgroup shares another one: behind a barrier.
fn share_product(level : Level, x : u32, node : u32, local : u32, is_idle : bool) {
  var sum = vec3f(0.0);
  if (!is_idle) { sum = lane_product(level, x, node, local % kLanes); }
  lane_x[local] = sum.x;
  lane_y[local] = sum.y;
  lane_z[local] = sum.z;
  workgroupBarrier();
  first_lane = local;
}

fn product(level : Level, x : u32, node : u32) -> vec3f {
  let at = first_lane;
  return vec3f((lane_x[at] + lane_x[at + 1u]) + (lane_x[at + 2u] + lane_x[at + 3u]),
               (lane_y[at] + lane_y[at + 1u]) + (lane_y[at + 2u] + lane_y[at + 3u]),
               (lane_z[at] + lane_z[at + 1u]) + (lane_z[at + 2u] + lane_z[at + 3u]));
}
