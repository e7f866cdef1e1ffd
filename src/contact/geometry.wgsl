// Shared by the tests on triangles and boxes.
#include "gpu/finite.wgsl"

struct Box { low : vec3f, high : vec3f }

// Of a determinant of differences, a sum of six products, in parts of the product of the largest components:
// contact/pushes/triangle_pair.wgsl.
const kRounding = 3.814697265625e-06;  // 64 * 2^-24

fn largest(a : vec3f) -> f32 { return max(max(abs(a.x), abs(a.y)), abs(a.z)); }
fn unit(v : vec3f) -> vec3f {
  let size = length(v);
  if (size > 0.0) { return v / size; }
  return vec3f(0.0);
}
