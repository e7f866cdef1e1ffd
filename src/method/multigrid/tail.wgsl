// The V-cycle on the coarsest levels of a grid or a mesh. One workgroup does all, a barrier for what would else be a
// dispatch. It finds the residual of the first of them and the first smoothing sweep there, and leaves the solution in
// kFirst. The including kernel binds `tail`, the levels, and defines the functions that smoothing.wgsl needs,
// restrict_node and correct_node. Source: docs/solvers/multigrid.md, equations 7 and 8.
#include "gpu/index.wgsl"
#include "method/multigrid/smoothing.wgsl"
#include "method/multigrid/whole_workgroup.wgsl"

// The coarsest level has nothing below it that could take the low eigenvalues, so more sweeps, for a wider range.
const kBottomLow = kHigh / 30.0;
const kBottomSweeps = 10u;

// The first sweep of Chebyshev's polynomial, start_level's, was for another range; the ratio corrects it. The
// others go to and fro between the two solutions; their number is odd, so that the last one is kFirst.
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
  for (var sweep = 1u; sweep < kBottomSweeps; sweep++) {
    let next = 1.0 / (2.0 * sigma - rho);
    let then = kFirst + kSecond - now;
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      let d = sweep_of(level, now, next * rho, 2.0 * next / half, node);
      vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
      vectors[vector_at(level, then, node)] = vec4f(operand(level, now, node) + d, 0.0);
    }
    storageBarrier();
    rho = next;
    now = then;
  }
}

fn solve_tail(local : u32) {
  if (are_all_idle(local, is_solved())) { return; }
  let last = arrayLength(&tail) - 1u;
  for (var l = 0u; l < last; l++) {
    let level = tail[l];
    let coarse = tail[l + 1u];
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      end_smoothing(level, kDirection, kFirst, node);
    }
    storageBarrier();
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { keep_residual(level, node); }
    storageBarrier();
    for (var node = local; node < node_count(coarse); node += kWorkgroupSize) { restrict_node(level, coarse, node); }
    storageBarrier();
  }
  solve_bottom(tail[last], local);
  for (var above = 0u; above < last; above++) {
    let level = tail[last - 1u - above];
    let coarse = tail[last - above];
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { correct_node(level, coarse, node); }
    storageBarrier();
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      begin_smoothing(level, kFirst, kSecond, node);
    }
    storageBarrier();
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      end_smoothing(level, kSecond, kFirst, node);
    }
    storageBarrier();
  }
}
