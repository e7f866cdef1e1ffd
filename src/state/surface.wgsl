// The normal and the stretch of every vertex, from the triangles around it. One invocation per vertex.
// Normal: the area-weighted mean of the triangles' normals (the sum of their cross products), unit.
// Stretch: the largest length / rest length of its edges; on a grid without the diagonals, which shear lengthens. What
// is sewn has for each corner of each triangle where that is in the pattern.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
struct SurfaceParams {  // mirror: src/state/surface.hpp
  first_vertex : u32,
  vertex_count : u32,
  row : u32,  // nodes a row of a grid; 0 for a mesh
}
//                                                                              elements
@group(0) @binding(0) var<uniform>             cloth      : SurfaceParams;
@group(0) @binding(1) var<storage, read>       position   : array<vec4f>;       // vertex_count, m
@group(0) @binding(2) var<storage, read>       rest       : array<vec4f>;       // vertex_count, 3 * triangle_count: m
@group(0) @binding(3) var<storage, read>       triangles  : array<u32>;         // 3 * triangle_count
@group(0) @binding(4) var<storage, read>       offsets    : array<u32>;         // vertex_count + 1
@group(0) @binding(5) var<storage, read>       around     : array<u32>;         // triangles around each vertex, rising
@group(0) @binding(6) var<storage, read_write> normal     : array<vec4f>;       // vertex_count
@group(0) @binding(7) var<storage, read_write> stretch    : array<f32>;         // vertex_count
@group(0) @binding(8) var<storage, read_write> statistics : array<atomic<u32>>; // see state/statistics.wgsl
override kCutFromPattern : bool = false;

// Of an edge between nodes a and b, which are corners k and l of all triangles.
fn edge_stretch(a : u32, b : u32, k : u32, l : u32) -> f32 {
  let apart = max(a, b) - min(a, b);
  if (cloth.row != 0u && apart != 1u && apart != cloth.row) { return 0.0; }
  let rest_a = rest[select(a, k, kCutFromPattern)].xyz;
  let rest_b = rest[select(b, l, kCutFromPattern)].xyz;
  return length(position[b].xyz - position[a].xyz) / length(rest_b - rest_a);
}

@compute @workgroup_size(kWorkgroupSize)
fn surface(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= cloth.vertex_count) { return; }
  let vertex = cloth.first_vertex + index;
  var sum = vec3f(0.0);
  var largest = 0.0;
  for (var entry = offsets[vertex]; entry < offsets[vertex + 1u]; entry++) {
    let t = 3u * around[entry];
    let a = triangles[t];
    let b = triangles[t + 1u];
    let c = triangles[t + 2u];
    let x = position[a].xyz;
    sum += cross(position[b].xyz - x, position[c].xyz - x);
    let own = t + select(select(2u, 1u, b == vertex), 0u, a == vertex);
    if (a != vertex) { largest = max(largest, edge_stretch(vertex, a, own, t)); }
    if (b != vertex) { largest = max(largest, edge_stretch(vertex, b, own, t + 1u)); }
    if (c != vertex) { largest = max(largest, edge_stretch(vertex, c, own, t + 2u)); }
  }
  let size = length(sum);
  normal[vertex] = vec4f(select(vec3f(0.0, 1.0, 0.0), sum / size, size > 0.0), 0.0);
  stretch[vertex] = largest;
  atomicMax(&statistics[kStatMaxStretch], bitcast<u32>(largest));  // bits of positive floats order as the floats do
}
