// The residual of a mesh at the start of the unknown, its matrix, and the inverse of the diagonal. One invocation per
// node, which keeps its row.
// Sums run in a fixed order. Source: docs/solvers/multigrid.md, equations 5, 6 and 11.
#include "gpu/index.wgsl"
#include "method/multigrid/mesh_row_end.wgsl"
#include "method/multigrid/spring.wgsl"
//                                                                                elements           unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<uniform>             nodes      : ClothNodes;
@group(0) @binding(2) var<uniform>             levels     : array<MeshLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       place      : array<vec4f>;      // node_count         m; w: N/m, 0: fixed
@group(0) @binding(4) var<storage, read_write> holds      : array<vec4f>;      // method/multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors    : array<vec4f>;      // method/multigrid/cloth.wgsl
@group(0) @binding(6) var<storage, read_write> blocks     : array<vec2f>;      // method/multigrid/mesh_block.wgsl
@group(0) @binding(7) var<storage, read>       row_starts : array<u32>;        // node_count + 1 of each level
@group(0) @binding(8) var<storage, read>       entries    : array<u32>;          // the node of each
@group(0) @binding(9) var<storage, read>       springs    : array<vec4f>;      // of each entry: m, N/m, N·s/m, m
@group(0) @binding(10) var<storage, read_write> presses   : array<i32>;        // press_sums.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn mesh_gradient(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  let level = levels[0];
  if (node >= level.node_count) { return; }
  let own = place[node];
  let start = vectors[vector_at(level, kFirst, node)].xyz;
  let start_velocity = vectors[vector_at(level, kSecond, node)].xyz;
  let rate = 1.0 / formula_of(step.time.step_ratio).he;
  var diagonal = identity(own.w);
  var residual = vectors[vector_at(level, kResidual, node)].xyz;
  let first = row_starts[node];
  for (var entry = first + 1u; entry < row_starts[node + 1u]; entry++) {
    let other = entries[entry];
    let at = place[other];
    let spring = springs[entry];
    let span_step = vectors[vector_at(level, kFirst, other)].xyz - start;
    let rate_of_span = vectors[vector_at(level, kSecond, other)].xyz - start_velocity;
    let pulled = pull_of(at.xyz - own.xyz, span_step, rate_of_span, law_of(spring.x, spring.w, spring.y), spring.z,
                         rate);
    let part = sum_of(outer(pulled.block.direction, pulled.block.along), identity(pulled.block.across));
    diagonal = sum_of(diagonal, part);
    residual += pulled.force;
    store_symmetric(entry, scaled(select(-1.0, 0.0, own.w == 0.0 || at.w == 0.0), part));
  }
  end_row(level, node, own.w, first, diagonal, residual);
}
