// Depth as the eye sees it, of a plane. Six vertices.
#include "render/frame.wgsl"
#include "render/floor_square.wgsl"
//                                                     elements
@group(0) @binding(0) var<uniform> frame : Frame;   // 1
@group(0) @binding(1) var<uniform> plane : Plane;   // 1

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> @builtin(position) vec4f { return floor_vertex(i).clip; }
