// Copies a picture, pixel by pixel, to its place in a target.
struct OverlayPlace {
  x : u32,      // of its top left corner [pixel]
  y : u32,
  width : u32,  // of the target [pixel]
  height : u32,
}
@group(0) @binding(0) var<uniform> place   : OverlayPlace;  // 1
@group(0) @binding(1) var          picture : texture_2d<f32>;

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> @builtin(position) vec4f {
  let corner = vec2f(f32(i == 1u || i == 4u || i == 5u), f32(i == 2u || i == 3u || i == 5u));
  let size = vec2f(f32(place.width), f32(place.height));
  let pixel = vec2f(f32(place.x), f32(place.y)) + corner * vec2f(textureDimensions(picture));
  let at = 2.0 * pixel / size - 1.0;
  return vec4f(at.x, -at.y, 0.0, 1.0);
}

@fragment
fn fragment_main(@builtin(position) pixel : vec4f) -> @location(0) vec4f {
  return textureLoad(picture, vec2i(pixel.xy) - vec2i(i32(place.x), i32(place.y)), 0);
}
