// The start of conjugate gradients: the residual's norm, and its product with the guess, which `predict` has left as
// p. A system behind the first has no guess, and gets the first smoothing sweep of its first cycle; with contact it has
// the norm of what weight pulls with. What Newton's method leaves is measured beside what rounding makes of it. One
// invocation per node.
// Source: docs/solvers/multigrid.md, equations 13 and 15a; docs/solvers/fem.md, equation 3.
#include "method/multigrid/fine_vectors.wgsl"
#include "method/multigrid/norm_scale.wgsl"
#include "state/pair_sums.wgsl"
#include "state/step.wgsl"
//                                                                                 elements
@group(0) @binding(3) var<storage, read>       place     : array<vec4f>;        // count  w: N/m, 0: fixed
@group(0) @binding(4) var<storage, read_write> pair_sums : array<u32>;          // state/pair_holds.wgsl
@group(0) @binding(5) var<uniform>             step      : StepBlock;
@group(0) @binding(6) var<storage, read>       scales    : array<f32>;          // norm_scale.wgsl
override kAgain : bool = false;  // true: of the second system
override kHolds : bool = false;  // true: obstacles may hold nodes
override kPairs : bool = false;  // true: pairs may be held apart, and the residual gets their forces
override kMeasures : bool = false;  // true: no system follows
const kHalfUnit = 5.9604645e-8;  // 2⁻²⁴: half a unit in the last place is at most so much of a number
const kMostOfDiagonal = 2.0;     // the largest eigenvalue of D⁻¹A, of elements with two ends

// w·D⁻¹w, w: what weight pulls at a node with, by its inertia, N/m.
fn weight_norm(level : Level, node : u32, inertia : f32) -> f32 {
  let pull = inertia * step.time.dt * step.time.dt * step.air.acceleration.xyz;
  return dot(pull, times(inverse_at(level, node), pull));
}

// What the residual's norm has because a node's place is rounded.
fn rounding_norm(level : Level, node : u32, at : vec3f) -> f32 {
  let off = kMostOfDiagonal * kHalfUnit * at;
  return dot(off * off, inverse(inverse_at(level, node)).diagonal);
}

@compute @workgroup_size(kWorkgroupSize)
fn begin_solve(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = id.z;
  let node = flat_index(id);
  let level = finest();
  var part = vec2f(0.0);
  if (node < nodes.count) {
    var r = vectors[vector_at(level, kResidual, node)].xyz;
    let vertex = nodes.first_vertex + cloth * nodes.count + node;
    if (kPairs && is_held_by_pairs(vertex)) {
      r += place[cloth * nodes.count + node].w * take_pair_sum(vertex);
      vectors[vector_at(level, kResidual, node)] = vec4f(r, 0.0);
    }
    let d = times(inverse_at(level, node), r);
    let scale = norm_scale(node);
    part.x = scale * dot(r, d);
    if (kAgain) {
      vectors[vector_at(level, kDirection, node)] = vec4f(kBegin * d, 0.0);
      if (kMeasures) { part.y = scale * rounding_norm(level, node, place[cloth * nodes.count + node].xyz); }
      if (kHolds) { part.y = scale * weight_norm(level, node, place[cloth * nodes.count + node].w); }
    } else {
      part.y = dot(r, vectors[vector_at(level, kSearch, node)].xyz);
    }
    vectors[vector_at(level, kSolution, node)] = vec4f(0.0);
  }
  store_partial(local, 1u, node, nodes.count, part);
}
