// Adds up the partial sums over a cloth's nodes, takes what conjugate gradients decide from the sum, and reports what
// the solution took. One workgroup a cloth, in an order that its size does not change.
// Source: docs/solvers/multigrid.md, equations 13 to 15; docs/solvers/fem.md, equations 2 and 3.
#include "gpu/finite.wgsl"
#include "gpu/index.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/chunks.wgsl"
#include "method/multigrid/solve.wgsl"
#include "method/multigrid/whole_workgroup.wgsl"
#include "state/statistics.wgsl"
//                                                                                elements
@group(0) @binding(0) var<uniform>             nodes      : ClothNodes;
@group(0) @binding(1) var<storage, read_write> vectors    : array<vec4f>;     // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       partials   : array<vec2f>;     // partial_sums.wgsl
@group(0) @binding(3) var<storage, read_write> statistics : array<atomic<u32>>;
override kSum : u32;
override kAgain : bool = false;  // true: of a system behind the first
override kLast : bool = false;   // true: of the only system, or one behind the first
override kMeasures : bool = false;  // true: of what Newton's method has left, which no system follows
const kFirstNorm = 0u;  // mirror: src/method/multigrid/kernels.cpp
const kSquare = 1u;     // p·A p
const kNorm = 2u;
const kRho = 3u;
const kGuessPart = 10.0;  // mirror: src/method/multigrid/solve_limits.hpp
const kLanes = 256u;
var<workgroup> lanes : array<vec2f, kLanes>;

fn partial(k : u32, count : u32) -> vec2f {
  return select(vec2f(0.0), partials[cloth * count + min(k, count - 1u)], k < count);
}
fn four(k : u32, count : u32) -> vec2f {
  return (partial(k, count) + partial(k + kLanes, count)) +
         (partial(k + 2u * kLanes, count) + partial(k + 3u * kLanes, count));
}

// Sixteen at a time, since one workgroup waits for each of its loads.
fn total(local : u32) -> vec2f {
  let count = chunk_count(nodes.count);
  for (var lane = local; lane < kLanes; lane += kWorkgroupSize) {
    var sum = vec2f(0.0);
    for (var k = lane; k < count; k += 16u * kLanes) {
      let a = four(k, count);
      let b = four(k + 4u * kLanes, count);
      let c = four(k + 8u * kLanes, count);
      let d = four(k + 12u * kLanes, count);
      sum = (((sum + a) + b) + c) + d;
    }
    lanes[lane] = sum;
  }
  workgroupBarrier();
  for (var half = kLanes / 2u; half > 0u; half /= 2u) {
    for (var lane = local; lane < half; lane += kWorkgroupSize) { lanes[lane] += lanes[lane + half]; }
    workgroupBarrier();
  }
  return lanes[0];
}

fn after(state : Solve, sum : vec2f) -> Solve {
  var next = state;
  if (kSum == kSquare) { next.rate = select(0.0, state.rho / sum.x, sum.x > 0.0); }
  if (kSum == kNorm) {
    next.left = sum.x;
    if (state.turn == 0u) { next.enough = nodes.residual * min(state.first, kGuessPart * kGuessPart * sum.x); }
    let enough = select(nodes.first_part, 1.0, kLast) * next.enough;
    next.done = sum.x <= enough || !is_finite(vec3f(sum.x));  // which `report` counts
    next.turn++;
  }
  if (kSum == kRho) {
    next.keep = select(0.0, sum.x / state.rho, state.turn > 1u && state.rho > 0.0);
    next.rho = sum.x;
  }
  return next;
}

fn report(state : Solve) {
  atomicMax(&statistics[kStatIterations], state.turn - 1u);
  atomicMax(&statistics[kStatCorrections], state.turn - state.begun);
  let has_norm = is_finite(vec3f(state.first, state.left, 0.0));
  if (has_norm && state.first > 0.0) {
    atomicMax(&statistics[kStatResidual], bitcast<u32>(sqrt(state.left / state.first)));
  }
  if (state.done && has_norm) { return; }
  if (nodes.may_retry == 1u && has_norm && !kMeasures) {
    atomicStore(&statistics[kStatRolledBack], 1u);
  } else {
    atomicAdd(&statistics[kStatUnsolved], 1u);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn add_up(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = group.z;
  if (are_all_idle(local, kSum != kFirstNorm && is_solved())) { return; }
  let sum = total(local);
  if (local != 0u) { return; }
  var state = Solve(sum.x, sum.x, 0.0, sum.y, 0.0, 1.0, 0u, sum.x == 0.0, 1u);
  if (kSum == kFirstNorm && kAgain) {
    let had = solve_state();
    let turn = max(had.turn, 1u);
    let wanted = select(had.enough, min(had.enough, nodes.residual * sum.y), sum.y > 0.0);
    let enough = select(wanted, max(had.enough, sum.y), kMeasures);
    let done = sum.x <= enough || !is_finite(vec3f(sum.x));
    state = Solve(had.first, sum.x, enough, 0.0, 0.0, 1.0, turn, done, turn);
  }
  if (kSum != kFirstNorm) { state = after(solve_state(), sum); }
  let is_last = state.done || (kSum == kNorm && state.turn >= state.begun + nodes.iterations);
  if (kMeasures || (kLast && is_last)) { report(state); }
  let at = solve_at();
  vectors[at] = vec4f(state.first, state.left, state.enough, state.rho);
  vectors[at + 1u] = vec4f(state.rate, state.keep, f32(state.turn), select(0.0, 1.0, state.done));
  vectors[at + 2u] = vec4f(f32(state.begun), 0.0, 0.0, 0.0);
}
