// Depth as the eye sees it, of cloths and obstacles. One vertex per index of the triangle list.
#include "render/frame.wgsl"
#include "render/placement.wgsl"
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>       frame     : Frame;                // 1
@group(0) @binding(1) var<storage, read> position  : array<vec4f>;         // vertex_count  m
@group(0) @binding(2) var<storage, read> placement : array<vec4f>;         // 3 * those that move

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> @builtin(position) vec4f {
  return frame.view_projection * vec4f(placed(position[i]), 1.0);
}
