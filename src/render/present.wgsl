// Copies a picture, pixel by pixel, into a texture of the same size.
@group(0) @binding(0) var picture : texture_2d<f32>;
override kEncode : u32 = 0u;  // 1: the format of the target is not sRGB, so its curve is applied here

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> @builtin(position) vec4f {
  return vec4f(4.0 * f32(i & 1u) - 1.0, 2.0 * f32(i & 2u) - 1.0, 0.0, 1.0);
}

fn linear_to_srgb(light : vec3f) -> vec3f {
  return select(1.055 * pow(light, vec3f(1.0 / 2.4)) - 0.055, 12.92 * light, light <= vec3f(0.0031308));
}

@fragment
fn fragment_main(@builtin(position) pixel : vec4f) -> @location(0) vec4f {
  let color = textureLoad(picture, vec2i(pixel.xy), 0);
  return vec4f(select(color.rgb, linear_to_srgb(color.rgb), kEncode == 1u), color.a);
}
