// Counts the tetrahedra that have lost nearly all of their volume, or are inside out. One invocation per tetrahedron.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
const kLeastVolume = 0.05;  // of that at rest
//                                                                              elements
@group(0) @binding(0) var<storage, read>       position   : array<vec4f>;       // vertex_count, m
@group(0) @binding(1) var<storage, read>       rest       : array<vec4f>;       // vertex_count, m
@group(0) @binding(2) var<storage, read>       corners    : array<vec4u>;       // tetrahedra
@group(0) @binding(3) var<storage, read_write> statistics : array<atomic<u32>>; // see state/statistics.wgsl

fn six_volumes(a : vec3f, b : vec3f, c : vec3f, d : vec3f) -> f32 { return dot(cross(b - a, c - a), d - a); }

@compute @workgroup_size(kWorkgroupSize)
fn flattened(@builtin(global_invocation_id) id : vec3u) {
  let tet = flat_index(id);
  if (tet >= arrayLength(&corners)) { return; }
  let at = corners[tet];
  let now = six_volumes(position[at.x].xyz, position[at.y].xyz, position[at.z].xyz, position[at.w].xyz);
  let before = six_volumes(rest[at.x].xyz, rest[at.y].xyz, rest[at.z].xyz, rest[at.w].xyz);
  if (now < kLeastVolume * before) { atomicAdd(&statistics[kStatFlattened], 1u); }
}
