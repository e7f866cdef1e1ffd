// Triangles of a panel over a picture: each vertex has a colour, whose alpha the atlas scales, and a rectangle outside
// of which nothing of its triangle is drawn. Their coordinates are pixels of the target.
struct OverlayParams {
  width : u32,         // of the target [pixel]
  height : u32,
  atlas_width : u32,   // [texel]; a multiple of 4
  atlas_height : u32,
}
struct OverlayVertex {
  x : f32,      // [pixel]
  y : f32,
  u : f32,      // in the atlas, from 0 to 1
  v : f32,
  color : u32,  // red in the lowest byte, alpha in the highest; sRGB
  clip : u32,
}
//                                                                               elements                        unit
@group(0) @binding(0) var<uniform>       params   : OverlayParams;         // 1
@group(0) @binding(1) var<storage, read> vertices : array<OverlayVertex>;  // vertex_count
@group(0) @binding(2) var<storage, read> clips    : array<vec4f>;          // clip_count                      pixel
@group(0) @binding(3) var<storage, read> atlas    : array<u32>;            // atlas_width * atlas_height / 4  4 alphas

struct Varyings {
  @builtin(position) position : vec4f,
  @location(0) color : vec4f,
  @location(1) texel : vec2f,
  @location(2) @interpolate(flat) clip : vec4f,
}

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Varyings {
  let vertex = vertices[i];
  let size = vec2f(f32(params.width), f32(params.height));
  let place = 2.0 * vec2f(vertex.x, vertex.y) / size - 1.0;
  let texels = vec2f(f32(params.atlas_width), f32(params.atlas_height));
  return Varyings(vec4f(place.x, -place.y, 0.0, 1.0), unpack4x8unorm(vertex.color), vec2f(vertex.u, vertex.v) * texels,
                  clips[vertex.clip]);
}

@fragment
fn fragment_main(in : Varyings) -> @location(0) vec4f {
  let pixel = in.position.xy;
  if (any(pixel < in.clip.xy) || any(pixel >= in.clip.zw)) { discard; }
  let last = vec2i(i32(params.atlas_width), i32(params.atlas_height)) - 1;
  let at = vec2u(clamp(vec2i(in.texel), vec2i(0), last));
  let alphas = unpack4x8unorm(atlas[(at.y * params.atlas_width + at.x) / 4u]);
  return vec4f(in.color.rgb, in.color.a * alphas[at.x % 4u]);
}
