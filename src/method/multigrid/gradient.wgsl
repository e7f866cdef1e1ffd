// What is left of the equation at the start of the unknown, the inverse of the matrix's diagonal, and the first step of smoothing. One
// invocation per node. Sums run in a fixed order: the same bits every run. Source: docs/solvers/multigrid.md, equations 5 and 6.
#include "gpu/index.wgsl"
#include "method/multigrid/bending.wgsl"
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/hold_at_obstacles.wgsl"
#include "method/multigrid/spring_pull.wgsl"
#include "method/multigrid/springs_of_node.wgsl"
#include "method/multigrid/store_inverse.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepParams;
@group(0) @binding(1) var<uniform>             grid        : SpringGrid;
@group(0) @binding(2) var<uniform>             levels      : array<Level, 2>;
@group(0) @binding(3) var<storage, read>       place       : array<vec4f>;   // nx * ny        m (w: N/m; 0: held)
@group(0) @binding(4) var<storage, read_write> holds       : array<vec4f>;   // method/multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors     : array<vec4f>;   // method/multigrid/level.wgsl
@group(0) @binding(6) var<storage, read_write> presses     : array<i32>;     // kPressWords * vertex_count
var<private> here : vec3f;
var<private> start : vec3f;
var<private> start_velocity : vec3f;
var<private> rate : f32;            // 1/s
var<private> diagonal : Symmetric;

fn operand(level : Level, node : u32) -> vec3f { return place[node].xyz + vectors[vector_at(level, kFirst, node)].xyz; }

fn pull(neighbour : u32, rest_length : f32, stiffness : f32, damping : f32) -> vec3f {
  let span_step = vectors[vector_at(levels[0], kFirst, neighbour)].xyz - start;
  var rate_of_span = vec3f(0.0);
  if (damping > 0.0) { rate_of_span = vectors[vector_at(levels[0], kSecond, neighbour)].xyz - start_velocity; }
  let pulled = pull_of(place[neighbour].xyz - here, span_step, rate_of_span, rest_length, stiffness, damping, rate);
  diagonal = sum_of(diagonal, sum_of(outer(pulled.block.direction, pulled.block.along), identity(pulled.block.across)));
  return pulled.force;
}

@compute @workgroup_size(kWorkgroupSize)
fn gradient(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= grid.nx * grid.ny) { return; }
  let level = levels[0];
  let own = place[node];
  if (own.w == 0.0) {
    store_inverse(level, node, zero_matrix());
    vectors[vector_at(level, kDirection, node)] = vec4f(0.0);
    if (kHolds) { free_of_obstacles(node, grid.first_vertex); }
    return;
  }
  let j = node / grid.nx;
  let i = node - j * grid.nx;
  here = own.xyz;
  start = vectors[vector_at(level, kFirst, node)].xyz;
  start_velocity = vectors[vector_at(level, kSecond, node)].xyz;
  rate = 1.0 / formula_of(step.step_ratio).he;
  diagonal = identity(own.w + bending_diagonal(level, i, j));
  let residual_at = vector_at(level, kResidual, node);
  var residual = vectors[residual_at].xyz + sum_of_springs(grid, i, j, node) - bending_product(level, i, j, node);
  if (kHolds) {
    let hold = hold_at_obstacles(node, grid.first_vertex, own.w, residual, start, diagonal);
    residual += hold.force;
    diagonal = sum_of(diagonal, hold.block);
  }
  let inverted = inverse(diagonal);
  vectors[residual_at] = vec4f(residual, 0.0);
  store_inverse(level, node, inverted);
  vectors[vector_at(level, kDirection, node)] = vec4f(kBegin * times(inverted, residual), 0.0);
}
