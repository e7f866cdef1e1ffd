// The residual at the start of the unknown, the poses of the springs, and the inverse of the matrix's diagonal. One
// invocation per node. Sums run
// in a fixed order: the same bits every run.
// Source: docs/solvers/multigrid.md, equations 5 and 6.
#include "gpu/index.wgsl"
#include "method/multigrid/air_block.wgsl"
#include "method/multigrid/bending.wgsl"
#include "method/multigrid/grid_springs.wgsl"
#include "method/multigrid/hold_at_obstacles.wgsl"
#include "method/multigrid/level_start.wgsl"
#include "element/spring/springs_of_node.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             grid        : SpringGrid;
@group(0) @binding(2) var<uniform>             levels      : array<GridLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       place       : array<vec4f>;   // nx * ny        m (w: N/m; 0: fixed)
@group(0) @binding(4) var<storage, read_write> holds       : array<vec4f>;   // method/multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors     : array<vec4f>;   // method/multigrid/cloth.wgsl
@group(0) @binding(6) var<storage, read_write> springs     : array<vec2u>;   // method/multigrid/grid_springs.wgsl
@group(0) @binding(7) var<storage, read_write> presses     : array<i32>;     // press_sums.wgsl
var<private> diagonal : Symmetric;

struct Own {  // the node whose springs are summed
  node : u32,
  place : vec3f,           // m
  start : vec3f,           // m
  start_velocity : vec3f,  // m/s
  rate : f32,              // 1/s
}

// Bending acts on where the nodes have come.
fn operand(level : Level, x : u32, node : u32) -> vec3f {
  return place[among_all(level, node)].xyz + vectors[vector_at(level, x, node)].xyz;
}

fn pull(own : Own, other : u32, number : u32, rest_length : f32, longest : f32, weight : f32, stiffness : f32,
        damping : f32) -> vec3f {
  let span_step = vectors[vector_at(levels[0], kFirst, other)].xyz - own.start;
  var rate_of_span = vec3f(0.0);
  if (damping > 0.0) { rate_of_span = vectors[vector_at(levels[0], kSecond, other)].xyz - own.start_velocity; }
  let span = place[among_all(levels[0], other)].xyz - own.place;
  let law = law_of(rest_length, longest, weight * stiffness);
  let pulled = pull_of(span, span_step, rate_of_span, law, weight * damping, own.rate);
  if (other > own.node) { springs[spring_at(levels[0], own.node, number)] = packed_pose(pulled.pose); }
  diagonal = sum_of(diagonal, sum_of(outer(pulled.block.direction, pulled.block.along), identity(pulled.block.across)));
  return pulled.force;
}

@compute @workgroup_size(kWorkgroupSize)
fn gradient(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let node = flat_index(id);
  if (node >= grid.nx * grid.ny) { return; }
  let level = levels[0];
  let whole = among_all(level, node);
  let here = place[whole];
  let j = node / grid.nx;
  let i = node - j * grid.nx;
  let start = vectors[vector_at(level, kFirst, node)].xyz;
  let start_velocity = vectors[vector_at(level, kSecond, node)].xyz;
  let own = Own(node, here.xyz, start, start_velocity, 1.0 / formula_of(step.time.step_ratio).he);
  diagonal = identity(here.w + bending_diagonal(level, i, j));
  let pulls = sum_of_springs(own, grid, node, grid.nx, i, j);
  if (here.w == 0.0) {
    store_inverse(level, node, zero_matrix());
    if (kHolds) { free_of_obstacles(whole, grid.first_vertex); }
    return;
  }
  var residual = vectors[vector_at(level, kResidual, node)].xyz + pulls - bending_product(level, kFirst, i, j, node);
  if (kAirPushes) { diagonal = sum_of(diagonal, air_block(level, node)); }
  if (kHolds) {
    let hold = hold_at_obstacles(whole, grid.first_vertex, here.w, diagonal, residual,
                                 vectors[vector_at(level, kWay, node)]);
    residual += hold.force;
    diagonal = sum_of(diagonal, hold.block);
  }
  store_inverse(level, node, inverse(diagonal));
  vectors[vector_at(level, kResidual, node)] = vec4f(residual, 0.0);
}
