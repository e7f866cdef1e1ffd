// A plane as a square floor that fades into the background, in the textured view. Six vertices.
#include "render/lit.wgsl"
#include "render/reflection.wgsl"
#include "render/material.wgsl"
#include "render/floor_square.wgsl"
//                                                                      elements
@group(0) @binding(0) var<uniform> frame     : Frame;                // 1
@group(0) @binding(1) var<uniform> light     : Light;                // 1
@group(0) @binding(2) var          depth_map : texture_depth_2d;     // as the eye sees it
@group(0) @binding(3) var          arriving  : texture_2d<f32>;      // red: sky, green: sun
@group(0) @binding(4) var<uniform> plane     : Plane;                // 1
const kPale = vec3f(0.335, 0.330, 0.322);
const kDim = vec3f(0.290, 0.286, 0.280);

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex { return floor_vertex(i); }

@fragment
fn fragment_main(in : Vertex) -> @location(0) vec4f {
  let square = in.at / plane.along.w;
  let board = checker(square, fwidth(square));
  let here = arriving_at(in.clip, vec2f(dpdx(in.clip.z), dpdy(in.clip.z)));
  let veins = in.at / (kVeins * frame.forward.w);
  let wide = fwidth(veins);
  let behind = backdrop(in.clip.xy);
  let fade = smoothstep(0.30, 1.0, length(in.at) / plane.center.w);
  let n = cross(plane.along.xyz, plane.across.xyz);
  let sky = irradiance(n);
  let sun = light.sun.rgb * saturate(dot(n, frame.to_light.xyz));
  if (plane.across.w == 0.0) {  // by how much darker a white ground would be here
    let open = dot(sky + sun, vec3f(1.0));
    let arrives = dot(here.sky * sky + here.sun * sun, vec3f(1.0));
    return vec4f(behind * mix(mix(0.45, 1.0, arrives / max(open, 1e-6)), 1.0, fade), 1.0);
  }
  let material = u32(plane.across.w) - 1u;
  var stuff = stone(material, vec3f(veins, 0.5), max(wide.x, wide.y));
  if (material != kMarble && material != kMetal) { stuff.albedo = mix(kDim, kPale, board); }
  let to_eye = normalize(frame.eye.xyz - in.position);
  return vec4f(mix(tone_map(stone_light(stuff, n, to_eye, here)), behind, fade), 1.0);
}
