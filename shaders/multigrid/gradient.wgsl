// What is left of the equation at the start of the unknown, the inverse of the matrix's diagonal, and the first step of smoothing. One
// invocation per node. Sums run in a fixed order: the same bits every run. Source: docs/solvers/multigrid.md, equations 5 and 6.
#include "shared/index.wgsl"
#include "multigrid/bending.wgsl"
#include "multigrid/chebyshev.wgsl"
#include "multigrid/springs_of_node.wgsl"
#include "multigrid/store_inverse.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepParams;
@group(0) @binding(1) var<uniform>             grid        : SpringGrid;
@group(0) @binding(2) var<uniform>             levels      : array<Level, 2>;
@group(0) @binding(3) var<storage, read>       place       : array<vec4f>;   // nx * ny        m (w: N/m; 0: held)
@group(0) @binding(4) var<storage, read_write> vectors     : array<vec4f>;   // multigrid/level.wgsl
var<private> here : vec3f;
var<private> start : vec3f;
var<private> start_velocity : vec3f;
var<private> rate : f32;            // 1/s
var<private> diagonal : Symmetric;

fn operand(level : Level, node : u32) -> vec3f { return place[node].xyz + vectors[vector_at(level, kFirst, node)].xyz; }

fn pull(neighbour : u32, rest_length : f32, stiffness : f32, damping : f32) -> vec3f {
  let span = place[neighbour].xyz - here;
  let hessian = spring_block(span, rest_length, stiffness, 0.0);
  let span_step = vectors[vector_at(levels[0], kFirst, neighbour)].xyz - start;
  let tension = stiffness * (length(span) - rest_length);
  var force = tension * hessian.direction + block_times(hessian, span_step);
  diagonal = sum_of(diagonal, sum_of(outer(hessian.direction, hessian.along + damping * rate), identity(hessian.across)));
  if (damping > 0.0) {  // along the spring as it will be: along its direction now, of first order in the step
    let later = span + span_step;
    let change = vectors[vector_at(levels[0], kSecond, neighbour)].xyz - start_velocity;
    let square = max(dot(later, later), kShortest * kShortest);
    force += (damping * dot(later, change) / square) * later;
  }
  return force;
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
  let residual = vectors[residual_at].xyz + sum_of_springs(grid, i, j, node) - bending_product(level, i, j, node);
  let inverted = inverse(diagonal);
  vectors[residual_at] = vec4f(residual, 0.0);
  store_inverse(level, node, inverted);
  vectors[vector_at(level, kDirection, node)] = vec4f(kBegin * times(inverted, residual), 0.0);
}
