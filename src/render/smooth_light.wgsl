// Gathers what arriving_light.wgsl has spread over 3 x 3 texels, from those of them that show the same surface. Shadows
// that are sharper than a texel stay so.
#include "render/frame.wgsl"
#include "render/depth_metres.wgsl"
//                                                                       elements
@group(0) @binding(0) var<uniform> frame     : Frame;                 // 1
@group(0) @binding(1) var          depth_map : texture_depth_2d;
@group(0) @binding(2) var          arriving  : texture_2d<f32>;       // red: sky, green: sun, blue: penumbra
#include "render/half_size.wgsl"
const kApart = 3.0;           // texel; what lies further off the surface's plane is another
const kPenumbraTexels = 8.0;  // as in arriving_light.wgsl

@fragment
fn fragment_main(@builtin(position) at : vec4f) -> @location(0) vec4f {
  let texel = vec2i(at.xy);
  let depth = depth_at(texel);
  let slope = depth_slope(texel, depth);
  let distance = distance_of(depth);
  let apart = kApart * footprint(distance, f32(textureDimensions(depth_map).y));
  var samples : array<vec3f, 9>;
  var soft = 0.0;
  for (var i = 0; i < 9; i++) {
    let away = vec2i(i % 3, i / 3) - 1;
    let there = clamp(texel + away, vec2i(0), last_texel());
    let off = depth_at(there) - depth - dot(slope, vec2f(away));
    let weight = saturate(1.0 - metres_of(off, distance) / apart);
    let one = textureLoad(arriving, there, 0);
    soft = max(soft, select(0.0, one.b, weight > 0.0));
    samples[i] = vec3f(one.rg, weight);
  }
  let spread = saturate(kPenumbraTexels * soft - 0.5);
  var sky = 0.0;
  var sun = 0.0;
  var sky_weight = 0.0;
  var sun_weight = 0.0;
  for (var i = 0; i < 9; i++) {
    let weight = samples[i].z;
    let own = weight * select(spread, 1.0, i == 4);
    sky += weight * samples[i].x;
    sky_weight += weight;
    sun += own * samples[i].y;
    sun_weight += own;
  }
  return vec4f(sky / sky_weight, sun / sun_weight, 0.0, 1.0);
}
