// The V-cycle on the coarsest levels of a mesh. One workgroup does all, a barrier for what would else be a dispatch. It finds the residual
// of the first of them and the first step of smoothing there, and leaves the solution. Source: docs/solvers/multigrid.md, equations 7 and 8.
#include "gpu/index.wgsl"
#include "method/multigrid/bottom.wgsl"
#include "method/multigrid/mesh_prolongation.wgsl"
#include "method/multigrid/mesh_restriction.wgsl"
#include "method/multigrid/mesh_steps.wgsl"
//                                                                                   elements
@group(0) @binding(0) var<storage, read>       tail          : array<MeshLevel>;  // the first of them, and all coarser ones
@group(0) @binding(1) var<storage, read_write> vectors       : array<vec4f>;      // method/multigrid/vectors.wgsl
@group(0) @binding(2) var<storage, read>       blocks        : array<vec4f>;      // method/multigrid/mesh_block.wgsl
@group(0) @binding(3) var<storage, read>       row_starts    : array<u32>;        // node_count + 1 of each level
@group(0) @binding(4) var<storage, read>       rows          : array<Coupling>;
@group(0) @binding(5) var<storage, read>       source_starts : array<u32>;        // node_count + 1 of each level
@group(0) @binding(6) var<storage, read>       sources       : array<Share>;      // of nodes of the finer level
@group(0) @binding(7) var<storage, read>       taps          : array<Share>;      // kTaps of each node: of nodes of the coarser level

// The first step of Chebyshev's polynomial, restriction's, was for another range: it is made good by the ratio. The others go to and fro
// between the two solutions; their number is odd, so that the last one is kSecond.
fn solve_bottom(level : Level, local : u32) {
  let middle = (kHigh + kBottomLow) / 2.0;
  let half = (kHigh - kBottomLow) / 2.0;
  let sigma = middle / half;
  for (var node = local; node < level.node_count; node += kWorkgroupSize) {
    let d = vectors[vector_at(level, kDirection, node)].xyz / (middle * kBegin);
    vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
    vectors[vector_at(level, kFirst, node)] = vec4f(d, 0.0);
  }
  storageBarrier();
  var rho = 1.0 / sigma;
  var now = kFirst;
  for (var step = 1u; step < kBottomSteps; step++) {
    let next = 1.0 / (2.0 * sigma - rho);
    let then = kFirst + kSecond - now;
    for (var node = local; node < level.node_count; node += kWorkgroupSize) {
      let d = step_of(level, now, next * rho, 2.0 * next / half, node);
      vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
      vectors[vector_at(level, then, node)] = vec4f(vectors[vector_at(level, now, node)].xyz + d, 0.0);
    }
    storageBarrier();
    rho = next;
    now = then;
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn mesh_tail(@builtin(local_invocation_index) local : u32) {
  let last = arrayLength(&tail) - 1u;
  for (var l = 0u; l < last; l++) {
    let level = tail[l];
    let coarse = tail[l + 1u];
    for (var node = local; node < level.node_count; node += kWorkgroupSize) { end_smoothing(level, kDirection, kFirst, node); }
    storageBarrier();
    for (var node = local; node < level.node_count; node += kWorkgroupSize) { keep_residual(level, node); }
    storageBarrier();
    for (var node = local; node < coarse.node_count; node += kWorkgroupSize) { restrict_node(level, coarse, node); }
    storageBarrier();
  }
  solve_bottom(tail[last], local);
  for (var above = 0u; above < last; above++) {
    let level = tail[last - 1u - above];
    let coarse = tail[last - above];
    for (var node = local; node < level.node_count; node += kWorkgroupSize) { prolong_node(level, coarse, node); }
    storageBarrier();
    for (var node = local; node < level.node_count; node += kWorkgroupSize) { begin_smoothing(level, kSecond, kFirst, node); }
    storageBarrier();
    for (var node = local; node < level.node_count; node += kWorkgroupSize) { end_smoothing(level, kFirst, kSecond, node); }
    storageBarrier();
  }
}
