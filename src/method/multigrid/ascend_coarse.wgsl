// Up to a coarse level of a grid from the next: the coarser level's correction, and two smoothing sweeps. A workgroup
// does kTile x kTile nodes; sweeps of nodes between two tiles are done by both.
// Source: docs/solvers/multigrid.md, equations 7 and 8.
#include "method/multigrid/grid_correction.wgsl"
#include "method/multigrid/grid_tile.wgsl"
#include "method/multigrid/level_solution.wgsl"
const kTile = 12u;                            // mirror: src/method/multigrid/grid_level_params.hpp
const kBegunSide = kTile + 2u * kReach;       // of the nodes that these look at
const kCorrectedSide = kTile + 4u * kReach;   // and of those that these look at
var<workgroup> corrected : array<vec3f, kCorrectedSide * kCorrectedSide>;
var<workgroup> begun : array<vec3f, kBegunSide * kBegunSide>;
var<private> start : vec2i;

// As kSecond the corrected solution, as kFirst that after the first sweep.
fn operand(level : Level, x : u32, node : u32) -> vec3f {
  if (x == kSecond) { return corrected[place_in(level, start - 2 * kReach, kCorrectedSide, node)]; }
  return begun[place_in(level, start - kReach, kBegunSide, node)];
}

@compute @workgroup_size(kWorkgroupSize)
fn ascend_coarse(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  cloth = group.z;
  let level = levels[0];
  let first = tile_start(level, kTile, flat_group(group));
  if (!has_work(local, level, first)) { return; }
  start = vec2i(first);
  for (var k = local; k < kCorrectedSide * kCorrectedSide; k += kWorkgroupSize) {
    let at = in_square(start - 2 * kReach, kCorrectedSide, k);
    if (is_node(level, at)) {
      let node = node_at(level, at);
      corrected[k] = vectors[vector_at(level, kSecond, node)].xyz + correction(level, levels[1], node);
    }
  }
  workgroupBarrier();
  for (var k = local; k < kBegunSide * kBegunSide; k += kWorkgroupSize) {
    let at = in_square(start - kReach, kBegunSide, k);
    if (is_node(level, at)) {
      let node = node_at(level, at);
      let d = kBegin * times(inverse_at(level, node), left_of(level, kSecond, node));
      begun[k] = operand(level, kSecond, node) + d;
      if (all(at >= start) && all(at < start + i32(kTile))) {
        vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
      }
    }
  }
  workgroupBarrier();
  storageBarrier();
  for (var k = local; k < kTile * kTile; k += kWorkgroupSize) {
    let at = in_square(start, kTile, k);
    if (is_node(level, at)) { end_smoothing(level, kFirst, kFirst, node_at(level, at)); }
  }
}
