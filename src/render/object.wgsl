// The obstacles in the views that show numbers: warm grey, matt. One vertex per index of the triangle list.
#include "render/lighting.wgsl"
#include "render/placement.wgsl"
//                                                                                 elements      unit
@group(0) @binding(0) var<uniform>       frame          : Frame;                // 1
@group(0) @binding(1) var                shadow_map     : texture_depth_2d;
@group(0) @binding(2) var                shadow_sampler : sampler_comparison;
@group(0) @binding(3) var<storage, read> position       : array<vec4f>;         // vertex_count  m
@group(0) @binding(4) var<storage, read> normal         : array<vec4f>;         // vertex_count  unit
@group(0) @binding(5) var<storage, read> placement      : array<vec4f>;         // 3 * those that move
const kAlbedo = vec3f(0.360, 0.335, 0.305);
const kDark = 0.11;  // of everything under lines, on the dark background
const kGloss = 0.10;

struct Vertex {
  @builtin(position) clip : vec4f,
  @location(0) position : vec3f,
  @location(1) normal : vec3f,
}

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex {
  let p = placed(position[i]);
  return Vertex(frame.view_projection * vec4f(p, 1.0), p, turned(normal[i].xyz, position[i]));
}

@fragment
fn fragment_main(in : Vertex, @builtin(front_facing) front : bool) -> @location(0) vec4f {
  let to_eye = normalize(frame.eye.xyz - in.position);
  let n = unit_or(in.normal, to_eye) * select(-1.0, 1.0, front);
  let facing = saturate(dot(n, frame.to_light.xyz));
  let sun = facing * sun_visible(in.position, n);
  let half_way = normalize(to_eye + frame.to_light.xyz);
  let gloss = kGloss * pow(saturate(dot(n, half_way)), 24.0) * sun;
  let light = kAlbedo * (kKey * sun + ambient(n, to_eye)) + gloss;
  return vec4f(select(tone_map(light), kDark * light, kView == kWireframe), 1.0);
}
