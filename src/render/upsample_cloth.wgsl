// The vertices and normals of a cloth that is drawn finer than it is simulated. One invocation per drawn vertex.
// Normal: from the derivatives of the same surface; continuous, and needs no triangles.
#include "gpu/index.wgsl"
#include "render/fine_grid.wgsl"
//                                                                          elements              unit
@group(0) @binding(0) var<uniform>             grid     : FineGrid;      // 1
@group(0) @binding(1) var<storage, read>       nodes    : array<vec4f>;  // of all cloths         m
@group(0) @binding(2) var<storage, read_write> vertices : array<vec4f>;  // drawn, of all cloths  m (w: 1)
@group(0) @binding(3) var<storage, read_write> normal   : array<vec4f>;  // the same              unit

@compute @workgroup_size(kWorkgroupSize)
fn upsample_cloth(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  let row = ((grid.nx - 1u) << grid.level) + 1u;
  let rows = ((grid.ny - 1u) << grid.level) + 1u;
  if (index >= row * rows) { return; }
  let x = cubic_at(index % row, grid.nx, grid.level);
  let y = cubic_at(index / row, grid.ny, grid.level);
  var place = vec3f(0.0);
  var along = vec3f(0.0);  // the derivative along the rows
  var down = vec3f(0.0);   // along the columns
  for (var k = 0u; k < 4u; k++) {
    let first = grid.first_node + stencil_node(y, k, grid.ny) * grid.nx;
    var value = vec3f(0.0);
    var slope = vec3f(0.0);
    for (var l = 0u; l < 4u; l++) {
      let node = nodes[first + stencil_node(x, l, grid.nx)].xyz;
      value += x.weight[l] * node;
      slope += x.slope[l] * node;
    }
    place += y.weight[k] * value;
    along += y.weight[k] * slope;
    down += y.slope[k] * value;
  }
  let n = cross(down, along);  // as the triangles face (mesh/grid.hpp)
  let size = length(n);
  vertices[grid.first_vertex + index] = vec4f(place, 1.0);
  normal[grid.first_vertex + index] = vec4f(select(vec3f(0.0, 1.0, 0.0), n / size, size > 0.0), 0.0);
}
