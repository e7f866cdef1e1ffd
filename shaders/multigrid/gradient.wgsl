// What is left of the equation at the start of the unknown, the inverse of the matrix's diagonal, and the first step of smoothing. One
// invocation per node. Sums run in a fixed order: the same bits every run. Source: docs/solvers/multigrid.md, equations 5 and 6.
#include "shared/index.wgsl"
#include "multigrid/bending.wgsl"
#include "multigrid/chebyshev.wgsl"
#include "multigrid/hold.wgsl"
#include "contact/press_sums.wgsl"
#include "multigrid/springs_of_node.wgsl"
#include "multigrid/store_inverse.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepParams;
@group(0) @binding(1) var<uniform>             grid        : SpringGrid;
@group(0) @binding(2) var<uniform>             levels      : array<Level, 2>;
@group(0) @binding(3) var<storage, read>       place       : array<vec4f>;   // nx * ny        m (w: N/m; 0: held)
@group(0) @binding(4) var<storage, read_write> holds       : array<vec4f>;   // multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors     : array<vec4f>;   // multigrid/level.wgsl
@group(0) @binding(6) var<storage, read_write> presses     : array<i32>;     // kPressWords * vertex_count
var<private> here : vec3f;
var<private> start : vec3f;
var<private> start_velocity : vec3f;
var<private> rate : f32;            // 1/s
const kHoldStiffness = 10.0;  // of the trace of the diagonal
const kAgree = 0.3;           // of the normals: with less there is no one direction to hold it along
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

// Takes what `press` has found of the node, for this substep alone.
fn free_of_obstacles(node : u32) {
  for (var word = 0u; word < kPressWords; word++) { presses[kPressWords * (grid.first_vertex + node) + word] = 0; }
  holds[node] = vec4f(0.0);
}

fn press_vector(word : u32) -> vec3f { return vec3f(f32(presses[word]), f32(presses[word + 1u]), f32(presses[word + 2u])) / kPressUnits; }

// Where the node would come nearer to obstacles than the thickness, or is there and pressed on: what holds it, in `holds` and the diagonal,
// and the force to where it belongs.
fn hold_at_obstacles(node : u32, inertia : f32, residual : vec3f) -> vec3f {
  let word = kPressWords * (grid.first_vertex + node);
  if (presses[word + kPressWeight] == 0) {
    holds[node] = vec4f(0.0);
    return vec3f(0.0);
  }
  let weight = f32(presses[word + kPressWeight]) / kPressUnits;
  let sum = press_vector(word + kPressNormal);
  let lack = f32(presses[word + kPressLack]) / (kLackUnits * weight) * step.thickness;
  let surface = press_vector(word + kPressSurface) / weight;
  let friction = f32(presses[word + kPressFriction]) / (kPressUnits * weight);
  free_of_obstacles(node);
  let size = length(sum);
  if (size < kAgree * weight) { return vec3f(0.0); }
  let n = sum / size;
  let pressed = inertia * lack - dot(residual, n);  // what it takes to hold it there
  if (pressed <= 0.0) { return vec3f(0.0); }
  let stiffness = kHoldStiffness * min(weight, 1.0) * (diagonal.diagonal.x + diagonal.diagonal.y + diagonal.diagonal.z);
  let most = friction * pressed * stiffness / (stiffness + inertia);  // what is held gives way a little
  let slip = start - step.dt * surface;
  let along = slip - dot(slip, n) * n;
  let needed = -inertia * along - (residual - dot(residual, n) * n);
  let grip = length(needed);
  if (grip <= most) {
    holds[node] = vec4f(vec3f(0.0), stiffness);
    diagonal = sum_of(diagonal, identity(stiffness));
    return stiffness * (lack * n - along);
  }
  holds[node] = vec4f(sqrt(stiffness) * n, 0.0);
  diagonal = sum_of(diagonal, outer(n, stiffness));
  return stiffness * lack * n + (most / grip) * needed;
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
    if (kHolds) { free_of_obstacles(node); }
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
  if (kHolds) { residual += hold_at_obstacles(node, own.w, residual); }
  let inverted = inverse(diagonal);
  vectors[residual_at] = vec4f(residual, 0.0);
  store_inverse(level, node, inverted);
  vectors[vector_at(level, kDirection, node)] = vec4f(kBegin * times(inverted, residual), 0.0);
}
