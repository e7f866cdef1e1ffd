// A cloth's normals or the numbers at its vertices, straight from the state's buffers. One vertex per index of the
// triangle list.
#include "render/frame.wgsl"
//                                                                          elements      unit
@group(0) @binding(0) var<uniform>       frame    : Frame;               // 1
@group(0) @binding(1) var<storage, read> position : array<vec4f>;        // vertex_count  m
@group(0) @binding(2) var<storage, read> normal   : array<vec4f>;        // vertex_count  unit
@group(0) @binding(3) var<storage, read> field    : array<f32>;          // what the view shows: see field_at

struct Vertex {
  @builtin(position) clip : vec4f,
  @location(0) position : vec3f,
  @location(1) normal : vec3f,
  @location(2) field : f32,
}

// Length / rest length; of the velocity, as vec4f, its size, m/s; the number of contacts.
fn field_at(i : u32) -> f32 {
  if (kView == kVelocity) { return length(vec3f(field[4u * i], field[4u * i + 1u], field[4u * i + 2u])); }
  return field[i];
}

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex {
  let p = position[i].xyz;
  return Vertex(frame.view_projection * vec4f(p, 1.0), p, normal[i].xyz, field_at(i));
}

fn facing_normal(in : Vertex, front : bool, to_eye : vec3f) -> vec3f {
  let n = unit_or(in.normal, to_eye);
  return select(-n, n, front);
}

@fragment
fn fragment_normals(in : Vertex, @builtin(front_facing) front : bool) -> @location(0) vec4f {
  let n = facing_normal(in, front, normalize(frame.eye.xyz - in.position));
  return vec4f(srgb_to_linear(0.5 + 0.5 * n), 1.0);
}

// Shaded by at most a quarter, so that folds show and the legend still holds.
@fragment
fn fragment_field(in : Vertex, @builtin(front_facing) front : bool) -> @location(0) vec4f {
  let n = facing_normal(in, front, normalize(frame.eye.xyz - in.position));
  let place = 8.0 * saturate((in.field - frame.field_range.x) * frame.field_range.z);
  let below = min(u32(place), 7u);
  let color = mix(frame.color_map[below].rgb, frame.color_map[below + 1u].rgb, place - f32(below));
  return vec4f(color * (0.75 + 0.25 * saturate(0.4 + 0.6 * dot(n, frame.to_light.xyz))), 1.0);
}
