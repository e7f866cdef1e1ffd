// A cloth's triangles as lines on a quiet sheet. Three vertices a triangle, not indexed, so that a fragment knows its
// distance from each side: the sheet hides the lines behind it and nothing has to be drawn twice. Lines have the same
// width everywhere, are smooth on any adapter (hardware lines are not), and fade as triangles get small, so that a
// fine mesh becomes a tone and not a blot.
#include "render/frame.wgsl"
#include "render/weave.wgsl"
//                                                                            elements            unit
@group(0) @binding(0) var<uniform>       frame     : Frame;                // 1
@group(0) @binding(1) var<uniform>       fabric    : Fabric;               // 1
@group(0) @binding(2) var<storage, read> position  : array<vec4f>;         // vertex_count        m
@group(0) @binding(3) var<storage, read> normal    : array<vec4f>;         // vertex_count        unit
@group(0) @binding(4) var<storage, read> triangles : array<u32>;           // 3 * triangle_count
const kHalfWidth = 0.6;   // pixel
const kFaintBelow = 1.5;  // pixel; a triangle of this height shows next to no lines
const kFullAbove = 8.0;   // pixel
const kFaintest = 0.12;

struct Vertex {
  @builtin(position) clip : vec4f,
  @location(0) position : vec3f,
  @location(1) normal : vec3f,
  @location(2) share : vec3f,  // of each corner: 0 on the side that lies opposite
}

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex {
  let v = triangles[i];
  let p = position[v].xyz;
  let corner = i % 3u;
  let share = vec3f(f32(corner == 0u), f32(corner == 1u), f32(corner == 2u));
  return Vertex(frame.view_projection * vec4f(p, 1.0), p, normal[v].xyz, share);
}

@fragment
fn fragment_main(in : Vertex, @builtin(front_facing) front : bool) -> @location(0) vec4f {
  let slope = max(fwidth(in.share), vec3f(1e-6));  // 1 / height of the triangle in pixels
  let to_eye = normalize(frame.eye.xyz - in.position);
  let n = unit_or(in.normal, to_eye) * select(-1.0, 1.0, front);
  let light = 0.25 + 0.75 * saturate(0.45 + 0.55 * dot(n, frame.to_light.xyz));
  let sheet = mix(vec3f(0.028, 0.032, 0.040), fabric.tint.rgb, 0.25) * light * select(0.5, 1.0, front);
  let line = mix(vec3f(0.55, 0.62, 0.70), fabric.tint.rgb, 0.35) * (0.5 + 0.6 * light) * select(0.6, 1.0, front);
  let cover = saturate(kHalfWidth + 0.5 - in.share / slope);
  let strength = mix(vec3f(kFaintest), vec3f(1.0), smoothstep(vec3f(kFaintBelow), vec3f(kFullAbove), 1.0 / slope));
  let lines = cover * strength;
  return vec4f(mix(sheet, line, max(lines.x, max(lines.y, lines.z))), 1.0);
}
