// The V-cycle on the coarsest levels of a grid or a mesh, by one workgroup, with barriers instead of dispatches. It
// finds the residual of the first of them and the first smoothing sweep there, and leaves the solution in kFirst. Of
// `vectors` an invocation reads its own nodes only. What nodes need of each other, one vector at a time, is in the
// workgroup's memory: a barrier for that memory takes less, and what invocations only read stays in their cache.
// The including kernel binds `tail`, the levels, and `bottom`, and defines their product A x, restrict_node and
// correct_node.
// Source: docs/solvers/multigrid.md, equations 7 and 8.
#include "gpu/index.wgsl"
#include "method/multigrid/smoothing.wgsl"
#include "method/multigrid/whole_workgroup.wgsl"

// The coarsest level has nothing below it that could take the low eigenvalues, so more sweeps, for a wider range.
struct BottomSweeps {  // mirror: src/method/multigrid/cycle.hpp
  count : u32,
  middle : f32,  // of the range
  half : f32,    // of what it spans
}

// Nodes of a level, but for the coarsest of a mesh, which has one of each piece and no couplings.
// Mirror: src/method/multigrid/bottom.hpp.
const kTailNodes = 682u;
// The vector that a stage reads, and the one that it writes, in turns; by components, so that 16 KiB are enough.
var<workgroup> shown_x : array<f32, 2u * kTailNodes>;
var<workgroup> shown_y : array<f32, 2u * kTailNodes>;
var<workgroup> shown_z : array<f32, 2u * kTailNodes>;
var<private> read_from : u32;  // 0 or kTailNodes

fn shown(level : Level, x : u32, node : u32) -> vec3f {
  if (node >= kTailNodes) { return vectors[vector_at(level, x, node)].xyz; }
  let at = read_from + node;
  return vec3f(shown_x[at], shown_y[at], shown_z[at]);
}
fn operand(level : Level, x : u32, node : u32) -> vec3f { return shown(level, x, node); }
fn left_at(level : Level, node : u32) -> vec3f { return shown(level, kDirection, node); }
fn solution_at(level : Level, node : u32) -> vec3f { return shown(level, kFirst, node); }

fn write_shown(node : u32, value : vec3f) {
  if (node >= kTailNodes) { return; }
  let at = kTailNodes - read_from + node;
  shown_x[at] = value.x;
  shown_y[at] = value.y;
  shown_z[at] = value.z;
}
fn keep_vector(level : Level, x : u32, node : u32, value : vec3f) {
  vectors[vector_at(level, x, node)] = vec4f(value, 0.0);
  write_shown(node, value);
}

// Ends a stage, which has written one vector of a level: the next one reads it.
fn end_stage(level : Level) {
  if (node_count(level) > kTailNodes) { storageBarrier(); }
  workgroupBarrier();
  read_from = kTailNodes - read_from;
}

// Shows the first sweep of a level.
fn show_start(level : Level, local : u32) {
  for (var node = local; node < node_count(level); node += kWorkgroupSize) {
    write_shown(node, vectors[vector_at(level, kDirection, node)].xyz);
  }
  end_stage(level);
}

// The first sweep of Chebyshev's polynomial, start_level's, was for another range; the ratio corrects it.
fn solve_bottom(level : Level, local : u32) {
  let middle = bottom.middle;
  let half = bottom.half;
  let sigma = middle / half;
  for (var node = local; node < node_count(level); node += kWorkgroupSize) {
    let d = vectors[vector_at(level, kDirection, node)].xyz / (middle * kBegin);
    vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
    keep_vector(level, kFirst, node, d);
  }
  end_stage(level);
  var rho = 1.0 / sigma;
  for (var sweep = 1u; sweep < bottom.count; sweep++) {
    let next = 1.0 / (2.0 * sigma - rho);
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      let d = sweep_of(level, kFirst, next * rho, 2.0 * next / half, node);
      vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
      keep_vector(level, kFirst, node, operand(level, kFirst, node) + d);
    }
    end_stage(level);
    rho = next;
  }
}

fn solve_tail(local : u32) {
  if (are_all_idle(local, is_solved())) { return; }
  let last = arrayLength(&tail) - 1u;
  for (var l = 0u; l < last; l++) {
    let level = tail[l];
    let coarse = tail[l + 1u];
    show_start(level, local);
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      end_smoothing(level, kDirection, kFirst, node);
    }
    end_stage(level);
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { keep_residual(level, node); }
    end_stage(level);
    for (var node = local; node < node_count(coarse); node += kWorkgroupSize) { restrict_node(level, coarse, node); }
  }
  solve_bottom(tail[last], local);
  for (var above = 0u; above < last; above++) {
    let level = tail[last - 1u - above];
    let coarse = tail[last - above];
    for (var node = local; node < node_count(level); node += kWorkgroupSize) { correct_node(level, coarse, node); }
    end_stage(level);
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      begin_smoothing(level, kFirst, kFirst, node);
    }
    end_stage(level);
    for (var node = local; node < node_count(level); node += kWorkgroupSize) {
      end_smoothing(level, kFirst, kFirst, node);
    }
    end_stage(level);
  }
}
