// What the facets of a cloth keep of their bends for good, as a substep begins, and where its moments read that: behind
// the bends of its hinges. One invocation per triangle. Source: docs/elements.md, Creases, equations 23 and 24.
#include "gpu/index.wgsl"
#include "element/hinge/yield.wgsl"
#include "method/fabric_params.wgsl"
override kBendWords : u32 = 1;  // of a bend: start_bends.wgsl
//                                                                            elements            unit
@group(0) @binding(0) var<uniform>             fabric  : FabricParams;
@group(0) @binding(1) var<uniform>             law     : YieldLaw;
@group(0) @binding(2) var<storage, read>       parts   : array<vec2u>;    // rows of 3 * triangles, then entries
@group(0) @binding(3) var<storage, read>       curving : array<vec4f>;    // 2 * triangles       1/m²
@group(0) @binding(4) var<storage, read_write> creases : array<vec4f>;    // of all facets       rad; w: 1/m
@group(0) @binding(5) var<storage, read_write> bends   : array<f32>;      // hinges, then three a facet: rad

// What falls to a facet of the angle at an edge.
fn part_of(place : u32) -> f32 {
  let row = parts[place];  // the first entry, and the one behind the last
  var angle = 0.0;
  for (var entry = row.x; entry < row.y; entry++) {
    let weighed = parts[entry];  // a hinge, and the bits of its weight
    angle += bitcast<f32>(weighed.y) * bends[kBendWords * weighed.x];
  }
  return angle;
}

@compute @workgroup_size(kWorkgroupSize)
fn yield_creases(@builtin(global_invocation_id) id : vec3u) {
  let triangle = flat_index(id);
  if (triangle >= fabric.triangles) { return; }
  let place = 3u * triangle;
  var crease = creases[law.first + triangle];
  let elastic = vec3f(part_of(place), part_of(place + 1u), part_of(place + 2u)) - crease.xyz;
  let straight = curving[2u * triangle].xyz;    // the diagonal of a symmetric matrix
  let mixed = curving[2u * triangle + 1u].xyz;  // twice its entries xy, yz, zx
  let square = dot(straight, elastic * elastic) + dot(mixed, elastic * elastic.yzx);
  let curvature = sqrt(max(0.0, square));
  let kept = kept_curvature(law, curvature, crease.w);
  if (kept > 0.0) {
    crease = vec4f(crease.xyz + kept / curvature * elastic, crease.w + kept);
    creases[law.first + triangle] = crease;
  }
  let behind = fabric.hinges + place;
  bends[kBendWords * behind] = crease.x;
  bends[kBendWords * (behind + 1u)] = crease.y;
  bends[kBendWords * (behind + 2u)] = crease.z;
}
