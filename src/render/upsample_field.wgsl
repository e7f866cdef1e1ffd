// The view's value at each vertex of a cloth that is drawn finer than it is simulated. One invocation per drawn vertex.
#include "gpu/index.wgsl"
#include "render/fine_grid.wgsl"
//                                                                      elements
@group(0) @binding(0) var<uniform>             grid  : FineGrid;     // 1
@group(0) @binding(1) var<storage, read>       nodes : array<f32>;   // kComponents * nodes of all cloths
@group(0) @binding(2) var<storage, read_write> field : array<f32>;   // kComponents * drawn vertices of all cloths
override kComponents : u32 = 1;  // of a value

@compute @workgroup_size(kWorkgroupSize)
fn upsample_field(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  let row = ((grid.nx - 1u) << grid.level) + 1u;
  let rows = ((grid.ny - 1u) << grid.level) + 1u;
  if (index >= row * rows) { return; }
  let x = cubic_at(index % row, grid.nx, grid.level);
  let y = cubic_at(index / row, grid.ny, grid.level);
  for (var component = 0u; component < kComponents; component++) {
    var sum = 0.0;
    for (var k = 0u; k < 4u; k++) {
      let first = grid.first_node + stencil_node(y, k, grid.ny) * grid.nx;
      for (var l = 0u; l < 4u; l++) {
        sum += y.weight[k] * x.weight[l] * nodes[kComponents * (first + stencil_node(x, l, grid.nx)) + component];
      }
    }
    field[kComponents * (grid.first_vertex + index) + component] = sum;
  }
}
