// Depth and metres. The includer declares `frame`.
// Depth is affine over the picture on a plane, so that it can be told by how much something lies off a plane.
fn distance_of(depth : f32) -> f32 {  // along the view, m
  return frame.right.w * frame.up.w / (frame.up.w - depth * (frame.up.w - frame.right.w));
}
// By how many metres something lies behind or before a depth from which its own differs by `change`.
fn metres_of(change : f32, distance : f32) -> f32 {
  return abs(change) * distance * distance * (1.0 / frame.right.w - 1.0 / frame.up.w);
}
// The height of a texel of a map with `rows` rows, m.
fn footprint(distance : f32, rows : f32) -> f32 { return 2.0 * length(frame.up.xyz) * distance / rows; }
