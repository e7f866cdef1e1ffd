// The background: one triangle over the whole picture, at the far end of depth.
#include "render/frame.wgsl"
#include "render/surroundings.wgsl"
#include "render/backdrop.wgsl"
//                                                     elements
@group(0) @binding(0) var<uniform> frame : Frame;   // 1
@group(0) @binding(1) var<uniform> light : Light;   // 1

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> @builtin(position) vec4f {
  return vec4f(4.0 * f32(i & 1u) - 1.0, 2.0 * f32(i & 2u) - 1.0, 1.0, 1.0);
}

@fragment
fn fragment_main(@builtin(position) pixel : vec4f) -> @location(0) vec4f {
  if (kView == kTextured) { return vec4f(backdrop(pixel.xy), 1.0); }
  return vec4f(background(pixel.xy), 1.0);
}
