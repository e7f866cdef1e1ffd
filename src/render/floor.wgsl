// A plane as a square floor that fades into the background. Six vertices.
#include "render/lighting.wgsl"
struct Plane {  // mirror: PlaneParams in src/render/floor.hpp
  center : vec4f,  // m, the point below the middle of the picture; w: half the side, m
  along : vec4f,   // unit; w: a checker square's side, m
  across : vec4f,  // unit; w: 1 for a floor, 0 for one that is seen only by the shadows on it
}
//                                                                                 elements
@group(0) @binding(0) var<uniform>       frame          : Frame;                // 1
@group(0) @binding(1) var                shadow_map     : texture_depth_2d;
@group(0) @binding(2) var                shadow_sampler : sampler_comparison;
@group(0) @binding(3) var<uniform>       plane          : Plane;                // 1
const kLight = vec3f(0.50, 0.495, 0.485);
const kDark = vec3f(0.026, 0.029, 0.034);  // under lines, on the dark background
const kDim = vec3f(0.43, 0.427, 0.42);

struct Vertex {
  @builtin(position) clip : vec4f,
  @location(0) position : vec3f,
  @location(1) at : vec2f,  // m from the center
}

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex {
  var corners = array(vec2f(-1, -1), vec2f(1, -1), vec2f(1, 1), vec2f(-1, -1), vec2f(1, 1), vec2f(-1, 1));
  let at = plane.center.w * corners[i];
  let p = plane.center.xyz + at.x * plane.along.xyz + at.y * plane.across.xyz;
  return Vertex(frame.view_projection * vec4f(p, 1.0), p, at);
}

// A checker board filtered over a box of `width`: Quilez, iquilezles.org/articles/checkerfiltering.
fn checker(at : vec2f, width : vec2f) -> f32 {
  let w = max(width, vec2f(1e-4));
  let i = 2.0 * (abs(fract((at - 0.5 * w) * 0.5) - 0.5) - abs(fract((at + 0.5 * w) * 0.5) - 0.5)) / w;
  return 0.5 - 0.5 * i.x * i.y;
}

@fragment
fn fragment_main(in : Vertex) -> @location(0) vec4f {
  let square = in.at / plane.along.w;
  let board = checker(square, fwidth(square));
  let behind = background(in.clip.xy);
  let fade = smoothstep(0.30, 1.0, length(in.at) / plane.center.w);
  let n = cross(plane.along.xyz, plane.across.xyz);
  let facing = saturate(dot(n, frame.to_light.xyz));
  let sun = sun_visible(in.position, n);
  if (plane.across.w == 0.0) {
    return vec4f(behind * mix(mix(0.62, 1.0, sun), 1.0, fade), 1.0);
  }
  let light = mix(kDim, kLight, board) * (kKey * (facing * sun) + mix(kGround, kSky, 0.5 + 0.5 * n.y));
  return vec4f(mix(select(tone_map(light), kDark * light, kView == kWireframe), behind, fade), 1.0);
}
