// The V-cycle on the coarsest levels of a grid or a mesh, by one workgroup, with barriers instead of dispatches. It
// finds the residual of the first of them and the first smoothing sweep there, and leaves the solution in kFirst. Of
// `vectors` an invocation reads its own nodes only. What nodes need of each other, one vector at a time, is in the
// workgroup's memory: a barrier for that memory takes less, and what invocations only read stays in their cache.
// The including kernel binds `tail`, the levels, and `bottom`, and defines kTailNodes, their product A x, restrict_node
// and correct_node.
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

override kShows : bool = true;  // false: of a level of more than kTailNodes, where a node needs its own only
// The vector that a stage reads, and the one that it writes, in turns; by components, so that 16 KiB are enough.
var<workgroup> shown_x : array<f32, 2u * kTailNodes>;
var<workgroup> shown_y : array<f32, 2u * kTailNodes>;
var<workgroup> shown_z : array<f32, 2u * kTailNodes>;
var<private> read_from : u32;  // 0 or kTailNodes

fn shown(level : Level, x : u32, node : u32) -> vec3f {
  if (!kShows) { return vectors[vector_at(level, x, node)].xyz; }
  let at = read_from + node;
  return vec3f(shown_x[at], shown_y[at], shown_z[at]);
}
fn operand(level : Level, x : u32, node : u32) -> vec3f { return shown(level, x, node); }
fn left_at(level : Level, node : u32) -> vec3f { return shown(level, kDirection, node); }
fn solution_at(level : Level, node : u32) -> vec3f { return shown(level, kFirst, node); }

fn write_shown(node : u32, value : vec3f) {
  if (!kShows) { return; }
  let at = kTailNodes - read_from + node;
  shown_x[at] = value.x;
  shown_y[at] = value.y;
  shown_z[at] = value.z;
}
fn keep_vector(level : Level, x : u32, node : u32, value : vec3f) {
  vectors[vector_at(level, x, node)] = vec4f(value, 0.0);
  write_shown(node, value);
}

// A node is always its first lane's, so that what only it needs is its invocation's own memory. The first one of an
// invocation; of other lanes none.
fn own_node(local : u32) -> u32 { return select(0xffffffffu, local / kLanes, local % kLanes == 0u); }

// For all invocations at once: whether this one has the product of a node, and takes it. `first`: the first of the
// nodes that they take now, of all in a stage.
fn has_product(level : Level, x : u32, first : u32, node : u32, local : u32) -> bool {
  let is_idle = node >= node_count(level);
  if (first > 0u) { workgroupBarrier(); }
  share_product(level, x, node, local, is_idle);
  return !is_idle && local % kLanes == 0u;
}

// Ends a stage, which has written one vector of a level: the next one reads it.
fn end_stage(level : Level) {
  if (!kShows) { storageBarrier(); }
  workgroupBarrier();
  read_from = kTailNodes - read_from;
}

// Shows the first sweep of a level.
fn show_start(level : Level, local : u32) {
  for (var node = own_node(local); node < node_count(level); node += kWorkgroupSize / kLanes) {
    write_shown(node, vectors[vector_at(level, kDirection, node)].xyz);
  }
  end_stage(level);
}

// The first sweep of Chebyshev's polynomial, start_level's, was for another range; the ratio corrects it.
fn solve_bottom(level : Level, local : u32) {
  let middle = bottom.middle;
  let half = bottom.half;
  let sigma = middle / half;
  for (var node = own_node(local); node < node_count(level); node += kWorkgroupSize / kLanes) {
    let d = vectors[vector_at(level, kDirection, node)].xyz / (middle * kBegin);
    vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
    keep_vector(level, kFirst, node, d);
  }
  end_stage(level);
  var rho = 1.0 / sigma;
  for (var sweep = 1u; sweep < bottom.count; sweep++) {
    let next = 1.0 / (2.0 * sigma - rho);
    for (var first = 0u; first < node_count(level); first += kWorkgroupSize / kLanes) {
      let node = first + local / kLanes;
      if (has_product(level, kFirst, first, node, local)) {
        let d = sweep_of(level, kDirection, kFirst, next * rho, 2.0 * next / half, node);
        vectors[vector_at(level, kDirection, node)] = vec4f(d, 0.0);
        keep_vector(level, kFirst, node, operand(level, kFirst, node) + d);
      }
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
    for (var first = 0u; first < node_count(level); first += kWorkgroupSize / kLanes) {
      let node = first + local / kLanes;
      if (has_product(level, kDirection, first, node, local)) { end_smoothing(level, kDirection, kFirst, node); }
    }
    end_stage(level);
    for (var first = 0u; first < node_count(level); first += kWorkgroupSize / kLanes) {
      let node = first + local / kLanes;
      if (has_product(level, kFirst, first, node, local)) { keep_residual(level, node); }
    }
    end_stage(level);
    for (var node = own_node(local); node < node_count(coarse); node += kWorkgroupSize / kLanes) {
      restrict_node(level, coarse, node);
    }
  }
  solve_bottom(tail[last], local);
  for (var above = 0u; above < last; above++) {
    let level = tail[last - 1u - above];
    let coarse = tail[last - above];
    for (var node = own_node(local); node < node_count(level); node += kWorkgroupSize / kLanes) {
      correct_node(level, coarse, node);
    }
    end_stage(level);
    for (var first = 0u; first < node_count(level); first += kWorkgroupSize / kLanes) {
      let node = first + local / kLanes;
      if (has_product(level, kFirst, first, node, local)) { begin_smoothing(level, kFirst, kFirst, node); }
    }
    end_stage(level);
    for (var first = 0u; first < node_count(level); first += kWorkgroupSize / kLanes) {
      let node = first + local / kLanes;
      if (has_product(level, kFirst, first, node, local)) { end_smoothing(level, kFirst, kFirst, node); }
    }
    end_stage(level);
  }
}
