// Down from a coarse level of a grid to the next: the second smoothing sweep, the residual, its Pᵀ and the first sweep
// there. A workgroup does kCoarseTile x kCoarseTile nodes of the coarser level, with the nodes above them; sweeps of
// nodes between two tiles are done by both. Source: docs/solvers/multigrid.md, equations 7 and 8.
#include "method/multigrid/grid_tile.wgsl"
#include "method/multigrid/grid_restriction.wgsl"
const kCoarseTile = 6u;                         // mirror: src/method/multigrid/grid_level_params.hpp
const kLeftSide = 2u * kCoarseTile + 1u;        // of the nodes that these take residuals from
const kSmoothedSide = kLeftSide + 2u * kReach;  // and of those that residuals take solutions from
var<workgroup> smoothed : array<vec3f, kSmoothedSide * kSmoothedSide>;
var<workgroup> left : array<vec3f, kLeftSide * kLeftSide>;
var<private> left_start : vec2i;
var<private> smoothed_start : vec2i;

// The first sweep, and as kSecond the solution after the second one.
fn operand(level : Level, x : u32, node : u32) -> vec3f {
  if (x == kSecond) { return smoothed[place_in(level, smoothed_start, kSmoothedSide, node)]; }
  return vectors[vector_at(level, x, node)].xyz;
}
fn left_at(level : Level, node : u32) -> vec3f { return left[place_in(level, left_start, kLeftSide, node)]; }

fn finer(coarse_node : vec2u) -> vec2i {
  return vec2i(vec2u(center_of(coarse_node.x, levels[0].nx, levels[1].nx),
                     center_of(coarse_node.y, levels[0].ny, levels[1].ny)));
}

// Each node of the level is one tile's own, which stores its solution.
fn own_end(first : vec2u) -> vec2i {
  let behind = first + kCoarseTile;
  return select(size_of(levels[0]), finer(behind), behind < vec2u(levels[1].nx, levels[1].ny));
}

@compute @workgroup_size(kWorkgroupSize)
fn descend_coarse(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = group.z;
  let fine = levels[0];
  let coarse = levels[1];
  let first = tile_start(coarse, kCoarseTile, flat_group(group));
  if (!has_work(local, coarse, first)) { return; }
  let own_start = finer(first);
  left_start = own_start - 1;
  smoothed_start = left_start - kReach;
  for (var k = local; k < kSmoothedSide * kSmoothedSide; k += kWorkgroupSize) {
    let at = in_square(smoothed_start, kSmoothedSide, k);
    if (is_node(fine, at)) {
      let node = node_at(fine, at);
      let x = operand(fine, kDirection, node) + sweep_of(fine, kDirection, kDirection, kKeep, kTake, node);
      smoothed[k] = x;
      if (all(at >= own_start) && all(at < own_end(first))) {
        vectors[vector_at(fine, kSecond, node)] = vec4f(x, 0.0);
      }
    }
  }
  workgroupBarrier();
  for (var k = local; k < kLeftSide * kLeftSide; k += kWorkgroupSize) {
    let at = in_square(left_start, kLeftSide, k);
    if (is_node(fine, at)) { left[k] = left_of(fine, kSecond, node_at(fine, at)); }
  }
  workgroupBarrier();
  for (var k = local; k < kCoarseTile * kCoarseTile; k += kWorkgroupSize) {
    let at = in_square(vec2i(first), kCoarseTile, k);
    if (is_node(coarse, at)) { restrict_node(fine, coarse, node_at(coarse, at)); }
  }
}
