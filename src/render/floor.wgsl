// A plane as a square floor that fades into the background, in the views that show numbers. Six vertices.
#include "render/lighting.wgsl"
#include "render/floor_square.wgsl"
//                                                                                 elements
@group(0) @binding(0) var<uniform>       frame          : Frame;                // 1
@group(0) @binding(1) var                shadow_map     : texture_depth_2d;
@group(0) @binding(2) var                shadow_sampler : sampler_comparison;
@group(0) @binding(3) var<uniform>       plane          : Plane;                // 1
const kLight = vec3f(0.50, 0.495, 0.485);
const kDark = vec3f(0.026, 0.029, 0.034);  // under lines, on the dark background
const kDim = vec3f(0.43, 0.427, 0.42);

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex { return floor_vertex(i); }

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
