// One sun with a shadow map and a sky, in the views that show numbers: what is around the cloth stays quiet there. The
// includer declares `frame`, `shadow_map` and `shadow_sampler`.
#include "render/frame.wgsl"
const kKey = vec3f(1.92, 1.85, 1.73);       // irradiance over pi, so that light = albedo * kKey * cos
const kSky = vec3f(0.37, 0.405, 0.465);
const kGround = vec3f(0.185, 0.168, 0.15);
const kTaps = 4u;            // bilinear, so 3.8 x 3.8 texels; nine over 5.2 looked the same and cost twice as much
const kTapOffset = 0.9;      // texel
const kNormalOffset = 2.0;   // texel; half of what the taps cover, so that a slope does not shade itself

// Sky and ground, a little stronger where a surface faces the eye, so that shaded parts keep their form.
fn ambient(normal : vec3f, to_eye : vec3f) -> vec3f {
  return mix(kGround, kSky, 0.5 + 0.5 * normal.y) * (0.72 + 0.40 * saturate(dot(normal, to_eye)));
}

// The share of the sun that arrives at a surface, 0 to 1; 1 where it faces away.
fn sun_visible(position : vec3f, normal : vec3f) -> f32 {
  let facing = dot(normal, frame.to_light.xyz);
  let slope = sqrt(saturate(1.0 - facing * facing));
  let lifted = position + normal * (kNormalOffset * frame.to_light.w * (0.35 + 0.65 * slope));
  let clip = frame.light_projection * vec4f(lifted, 1.0);  // orthographic: w is 1
  let at = vec2f(0.5 + 0.5 * clip.x, 0.5 - 0.5 * clip.y);
  let inside = all(at >= vec2f(0.0)) && all(at <= vec2f(1.0));
  let depth = min(clip.z, 1.0);  // a floor may lie beyond the map's end: what casts a shadow on it does not
  // No return for what lies outside: software adapters go through both sides of an `if`, but not through a loop that
  // none of their lanes needs.
  let taps = select(0u, kTaps, inside && facing > 0.0);
  let step = kTapOffset / f32(textureDimensions(shadow_map).x);
  var sum = 0.0;
  for (var i = 0u; i < taps; i++) {
    let offset = step * (2.0 * vec2f(f32(i & 1u), f32(i >> 1u)) - 1.0);
    sum += textureSampleCompareLevel(shadow_map, shadow_sampler, at + offset, depth);
  }
  return select(1.0, sum / f32(kTaps), taps > 0u);
}
