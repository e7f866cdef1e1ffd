// The forces of a cloth's triangles on their corners, in their plane. One invocation per triangle.
// Source: docs/elements.md, Membrane.
#include "gpu/index.wgsl"
#include "method/fabric_params.wgsl"
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>             fabric   : FabricParams;
@group(0) @binding(1) var<storage, read>       corners  : array<u32>;      // 3 * triangles
@group(0) @binding(2) var<storage, read>       slopes   : array<vec4f>;    // triangles     1/m: membrane/build.hpp
@group(0) @binding(3) var<storage, read>       position : array<vec4f>;    // vertex_count  m
@group(0) @binding(4) var<storage, read>       velocity : array<vec4f>;    // vertex_count  m/s
@group(0) @binding(5) var<storage, read_write> forces   : array<vec4f>;    // 3 * triangles + 4 * hinges, N

@compute @workgroup_size(kWorkgroupSize)
fn fabric_membranes(@builtin(global_invocation_id) id : vec3u) {
  let triangle = flat_index(id);
  if (triangle >= fabric.triangles) { return; }
  let a = corners[3u * triangle];
  let b = corners[3u * triangle + 1u];
  let c = corners[3u * triangle + 2u];
  let x = position[a].xyz;
  let v = velocity[a].xyz;
  let f = deformation(slopes[triangle], position[b].xyz - x, position[c].xyz - x);
  let rate = deformation(slopes[triangle], velocity[b].xyz - v, velocity[c].xyz - v);
  let found = membrane_forces(slopes[triangle], membrane_stress(fabric.law, f, rate));
  forces[3u * triangle] = vec4f(-(found.second + found.third), 0.0);
  forces[3u * triangle + 1u] = vec4f(found.second, 0.0);
  forces[3u * triangle + 2u] = vec4f(found.third, 0.0);
}
