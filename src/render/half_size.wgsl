// What the passes at half the picture's size share: places from depth. The includer declares `frame` and `depth_map`.
@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> @builtin(position) vec4f {
  return vec4f(4.0 * f32(i & 1u) - 1.0, 2.0 * f32(i & 2u) - 1.0, 0.0, 1.0);
}

fn last_texel() -> vec2i { return vec2i(textureDimensions(depth_map)) - 1; }
fn depth_at(texel : vec2i) -> f32 { return textureLoad(depth_map, clamp(texel, vec2i(0), last_texel()), 0); }

// How depth changes by a texel along x and y, on the surface that is seen here: of both sides the slighter change.
fn depth_slope(texel : vec2i, depth : f32) -> vec2f {
  let left = depth - depth_at(texel - vec2i(1, 0));
  let right = depth_at(texel + vec2i(1, 0)) - depth;
  let above = depth - depth_at(texel - vec2i(0, 1));
  let below = depth_at(texel + vec2i(0, 1)) - depth;
  return vec2f(select(right, left, abs(left) < abs(right)), select(below, above, abs(above) < abs(below)));
}
