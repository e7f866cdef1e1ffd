// The uniforms of every draw of a picture, and their shared functions: background, tone curve, colour of a normal.
// Mirror: src/render/frame_params.hpp. The includer declares `frame`.
struct Frame {
  view_projection : mat4x4f,   // world [m] to clip
  light_projection : mat4x4f,  // world [m] to the shadow map's clip
  eye : vec4f,                 // m
  to_light : vec4f,            // unit; w: the side of a shadow-map texel, m
  viewport : vec4f,            // width, height [pixel] and their inverses
  field_range : vec4f,         // lowest, highest, 1 / (highest - lowest)
  color_map : array<vec4f, 9>, // linear red, green, blue at equal distances over field_range
  right : vec4f,               // half the picture's width at a distance of 1; w: where depth begins, m
  up : vec4f,                  // half its height there; w: where depth ends, m
  forward : vec4f,             // unit; w: how far things keep the sky from each other, m
  shadow_span : vec4f,         // width, height and depth of the shadow map, m
}
override kView : u32 = 0u;
const kTextured = 0u;  // scene::View
const kWireframe = 1u;
const kVelocity = 4u;

// Quiet, lighter above, a little darker towards the corners; given after the tone curve, linear.
fn background(pixel : vec2f) -> vec3f {
  let at = pixel * frame.viewport.zw;
  let corner = dot(at - 0.5, at - 0.5);
  let dark = mix(vec3f(0.0160, 0.0190, 0.0250), vec3f(0.0075, 0.0090, 0.0125), at.y) * (1.0 - 0.5 * corner);
  let bright = mix(vec3f(0.800, 0.835, 0.875), vec3f(0.520, 0.545, 0.585), smoothstep(0.0, 1.0, at.y));
  return select(bright * (1.0 - 0.28 * corner), dark, kView == kWireframe);
}

// The shoulder of Khronos PBR Neutral (github.com/KhronosGroup/ToneMapping): leaves all but highlights alone, and those
// keep their hue. Its toe takes away a Fresnel term, which is not part of our light.
const kShoulder = 0.76;
const kDesaturation = 0.15;
fn tone_map(light : vec3f) -> vec3f {
  let peak = max(light.x, max(light.y, light.z));
  if (peak < kShoulder) { return light; }
  let room = 1.0 - kShoulder;
  let new_peak = 1.0 - room * room / (peak + room - kShoulder);
  let grey = 1.0 - 1.0 / (kDesaturation * (peak - new_peak) + 1.0);
  return mix(light * (new_peak / peak), vec3f(new_peak), grey);
}

// So that the bytes of the sRGB target are 255 * `encoded`.
fn srgb_to_linear(encoded : vec3f) -> vec3f {
  return select(pow((encoded + 0.055) / 1.055, vec3f(2.4)), encoded / 12.92, encoded <= vec3f(0.04045));
}

fn unit_or(v : vec3f, fallback : vec3f) -> vec3f {
  let square = dot(v, v);
  return select(fallback, v * inverseSqrt(max(square, 1e-30)), square > 1e-20);
}
