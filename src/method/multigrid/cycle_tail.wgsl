// The V-cycle on the coarsest levels. One workgroup does all, a barrier for what would else be a dispatch. It finds the residual of the
// first of them and the first step of smoothing there, and leaves the solution. Source: docs/solvers/multigrid.md, equations 7 and 8.
#include "gpu/index.wgsl"
#include "method/multigrid/bottom.wgsl"
#include "method/multigrid/coarse_steps.wgsl"
#include "method/multigrid/correction.wgsl"
#include "method/multigrid/restriction.wgsl"
//                                                                            elements
@group(0) @binding(0) var<storage, read>       tail      : array<Level>;   // the first of them, and all coarser ones
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;   // method/multigrid/level.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;   // method/multigrid/coarse_block.wgsl

var<private> operand_vector : u32;  // which solution a step goes on from

fn operand(level : Level, node : u32) -> vec3f { return vectors[vector_at(level, operand_vector, node)].xyz; }

fn node_count(level : Level) -> u32 { return level.nx * level.ny; }

// The first step of Chebyshev's polynomial, restriction's, was for another range: it is made good by the ratio. The others go to and fro
// between the two solutions; their number is odd, so that the last one is kFirst.
fn solve_bottom(level : Level, local : u32) {
  let middle = (kHigh + kBottomLow) / 2.0;
  let half = (kHigh - kBottomLow) / 2.0;
  let sigma = middle / half;
  for (var node = local; node < node_count(level); node += kWorkgroupSize) {
    let d = vectors[vector_at(level, kDirection, node)].xyz / (middle * kBegin);
    vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
    vectors[vector_at(level, kSecond, node)] = vec4f(d, 0.0);
  }
  storageBarrier();
  var rho = 1.0 / sigma;
  var now = kSecond;
  for (var step = 1u; step < kBottomSteps; step++) {
    let next = 1.0 / (2.0 * sigma - rho);
    let then = kFirst + kSecond - now;
    operand_vector = now;
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      let left = left_of(level, node);
      let d = next * rho * vectors[vector_at(level, kDirection, node)].xyz + (2.0 * next / half) * times(inverse_at(level, node), left);
      vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
      vectors[vector_at(level, then, node)] = vec4f(operand(level, node) + d, 0.0);
    }
    storageBarrier();
    rho = next;
    now = then;
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn cycle_tail(@builtin(local_invocation_index) local : u32) {
  let last = arrayLength(&tail) - 1u;
  for (var l = 0u; l < last; l++) {
    let level = tail[l];
    let coarse = tail[l + 1u];
    operand_vector = kDirection;
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { smooth_node(level, kFirst, kKeep, kTake, node); }
    storageBarrier();
    operand_vector = kFirst;
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { residual_node(level, node); }
    storageBarrier();
    for (var node = local; node < node_count(coarse); node += kWorkgroupSize) { restrict_node(level, coarse, node); }
    storageBarrier();
  }
  solve_bottom(tail[last], local);
  for (var above = 0u; above < last; above++) {
    let level = tail[last - 1u - above];
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { correct_node(level, tail[last - above], node); }
    storageBarrier();
    operand_vector = kFirst;
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { prolong_node(level, node); }
    storageBarrier();
    operand_vector = kSecond;
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { smooth_node(level, kFirst, kKeep, kTake, node); }
    storageBarrier();
  }
}
