// Copies a picture, pixel by pixel, into a texture of the same size.
@group(0) @binding(0) var picture : texture_2d<f32>;

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> @builtin(position) vec4f {
  return vec4f(4.0 * f32(i & 1u) - 1.0, 2.0 * f32(i & 2u) - 1.0, 0.0, 1.0);
}

@fragment
fn fragment_main(@builtin(position) pixel : vec4f) -> @location(0) vec4f {
  return textureLoad(picture, vec2i(pixel.xy), 0);
}
