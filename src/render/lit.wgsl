// What arrives of sun and sky at a fragment, from the map of half the picture's size: its four nearest texels, as far
// as they show the fragment's surface. The includer declares `frame`, `light`, `depth_map` and `arriving`.
#include "render/frame.wgsl"
#include "render/depth_metres.wgsl"
#include "render/surroundings.wgsl"
#include "render/backdrop.wgsl"
const kApart = 3.0;  // texel; what lies further off the surface's plane is another

struct Arriving {
  sky : f32,  // 0 to 1, of what the surroundings would send
  sun : f32,
}

// Reads  at: the fragment's position; slope: how its depth changes by a pixel, taken where control flow is uniform.
fn arriving_at(at : vec4f, slope : vec2f) -> Arriving {
  let size = vec2f(textureDimensions(depth_map));
  let place = at.xy * frame.viewport.zw * size - 0.5;
  let first = floor(place);
  let part = place - first;
  let by_texel = slope * frame.viewport.xy / size;
  let distance = distance_of(at.z);
  let apart = kApart * footprint(distance, size.y);
  var sum = vec2f(0.0);
  var weights = 0.0;
  for (var i = 0u; i < 4u; i++) {
    let corner = vec2f(f32(i & 1u), f32(i >> 1u));
    let there = vec2i(clamp(first + corner, vec2f(0.0), size - 1.0));
    let off = textureLoad(depth_map, there, 0) - at.z - dot(by_texel, first + corner - place);
    let same = saturate(1.0 - metres_of(off, distance) / apart) + 1e-3;
    let near = mix(1.0 - part, part, corner);
    let weight = same * (near.x * near.y + 1e-3);
    sum += weight * textureLoad(arriving, there, 0).rg;
    weights += weight;
  }
  return Arriving(sum.x / weights, sum.y / weights);
}

// The part of the sky that lights a surface where `open` of it is seen, by what it mirrors itself: Jimenez et al.
// (2016), "GTAO colored".
fn lit_by(open : f32, albedo : vec3f) -> vec3f {
  let a = 2.0404 * albedo - 0.3324;
  let b = -4.7951 * albedo + 0.6417;
  let c = 2.7552 * albedo + 0.6903;
  return max(vec3f(open), ((open * a + b) * open + c) * open);
}
