// Whether a segment passes through a triangle: its ends are on two sides of the triangle, and the triangle's edges pass
// it on one and the same side. Source: signed volumes, as in Segura and Feito 2001. Each is a sum of six products of
// three coordinate differences, so a value below 64 roundings of the largest product may be 0 (docs/collision.md,
// "Tolerance"): touching is not crossing, and neither is lying in one plane.
#include "contact/geometry.wgsl"

fn volume(a : vec3f, b : vec3f, c : vec3f) -> f32 { return dot(a, cross(b, c)); }

fn crosses(p : vec3f, q : vec3f, a : vec3f, b : vec3f, c : vec3f) -> bool {
  let size = max(max(largest(a - p), largest(b - p)),
                 max(max(largest(c - p), largest(q - p)), max(largest(a - q), largest(b - q))));
  let none = kRounding * size * size * size;
  let from_p = volume(a - p, b - p, c - p);
  let from_q = volume(a - q, b - q, c - q);
  if (min(abs(from_p), abs(from_q)) <= none || (from_p > 0.0) == (from_q > 0.0)) { return false; }
  let d = q - p;
  let ab = volume(d, a - p, b - p);
  let bc = volume(d, b - p, c - p);
  let ca = volume(d, c - p, a - p);
  return min(min(ab, bc), ca) > none || max(max(ab, bc), ca) < -none;
}

// Where a segment that crosses a triangle passes through it, as weights of the second and the third corner.
fn crossing_place(p : vec3f, q : vec3f, a : vec3f, b : vec3f, c : vec3f) -> vec2f {
  let d = q - p;
  let ab = volume(d, a - p, b - p);
  let bc = volume(d, b - p, c - p);
  let ca = volume(d, c - p, a - p);
  let sum = ab + bc + ca;
  if (sum == 0.0) { return vec2f(0.0); }
  return vec2f(ca, ab) / sum;
}
