// The residual of a cloth of fabric at the start of the unknown, and the diagonal of its matrix. One invocation per
// node. Sums run in a fixed order. Source: docs/solvers/multigrid.md, Fabric, and equation 11.
#include "gpu/index.wgsl"
#include "method/multigrid/mesh_row_end.wgsl"
#include "method/multigrid/spring.wgsl"
//                                                                               elements           unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<uniform>             nodes      : ClothNodes;
@group(0) @binding(2) var<uniform>             levels     : array<MeshLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       place      : array<vec4f>;      // node_count       m; w: N/m, 0: fixed
@group(0) @binding(4) var<storage, read_write> holds      : array<vec4f>;      // method/multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors    : array<vec4f>;      // method/multigrid/cloth.wgsl
@group(0) @binding(6) var<storage, read_write> blocks     : array<vec2f>;      // method/multigrid/mesh_block.wgsl
@group(0) @binding(7) var<storage, read>       row_starts : array<u32>;        // node_count + 1 of each level
@group(0) @binding(8) var<storage, read>       gathers    : array<u32>;        // rows of nodes, then their forces
@group(0) @binding(9) var<storage, read>       forces     : array<vec4f>;      // of all elements, N
@group(0) @binding(10) var<storage, read_write> presses   : array<i32>;        // press_sums.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn element_gradient(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  let level = levels[0];
  if (node >= level.node_count) { return; }
  var residual = vectors[vector_at(level, kResidual, node)].xyz;
  for (var k = gathers[node]; k < gathers[node + 1u]; k++) { residual += forces[gathers[k]].xyz; }
  let inertia = place[node].w;
  let entry = row_starts[node];
  let diagonal = sum_of(identity(inertia), block_of(entry).symmetric);
  end_row(level, node, inertia, entry, diagonal, residual);
}
