// The obstacles in the textured view. One vertex per index of the triangle list.
#include "render/lit.wgsl"
#include "render/reflection.wgsl"
#include "render/material.wgsl"
#include "render/placement.wgsl"
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>       frame     : Frame;                // 1
@group(0) @binding(1) var<uniform>       light     : Light;                // 1
@group(0) @binding(2) var                depth_map : texture_depth_2d;     // as the eye sees it
@group(0) @binding(3) var                arriving  : texture_2d<f32>;      // red: sky, green: sun
@group(0) @binding(4) var<storage, read> position  : array<vec4f>;         // vertex_count  m
@group(0) @binding(5) var<storage, read> normal    : array<vec4f>;         // vertex_count  unit; w: scene::Material
@group(0) @binding(6) var<storage, read> placement : array<vec4f>;         // 3 * those that move

struct Vertex {
  @builtin(position) clip : vec4f,
  @location(0) position : vec3f,
  @location(1) normal : vec3f,
  @location(2) at : vec3f,  // before it moves
  @location(3) @interpolate(flat) material : u32,
}

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex {
  let p = placed(position[i]);
  return Vertex(frame.view_projection * vec4f(p, 1.0), p, turned(normal[i].xyz, position[i]), position[i].xyz,
                u32(normal[i].w));
}

@fragment
fn fragment_main(in : Vertex, @builtin(front_facing) front : bool) -> @location(0) vec4f {
  let here = arriving_at(in.clip, vec2f(dpdx(in.clip.z), dpdy(in.clip.z)));
  let veins = in.at / (kVeins * frame.forward.w);
  let wide = fwidth(veins);
  let stuff = stone(in.material, veins, max(wide.x, max(wide.y, wide.z)));
  let to_eye = normalize(frame.eye.xyz - in.position);
  let n = unit_or(in.normal, to_eye) * select(-1.0, 1.0, front);
  return vec4f(tone_map(stone_light(stuff, n, to_eye, here)), 1.0);
}
