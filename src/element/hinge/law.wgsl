// The angle at an edge a b between the triangles a b c and b a d, and its slopes. The same as law.hpp in f32.
// Source: docs/elements.md, Bending.

const kMinArea = 1e-10;  // m²; a triangle of less has no direction to bend in
const kAtan = array<f32, 8>(0.00254626898, -0.0148145761, 0.0405767448, -0.073175177,
                            0.105490007, -0.141789928, 0.19989419, -0.33332935);  // the highest first
// atan(y / x) in the half plane that the signs say, in (-pi, pi]: drivers have an atan2 of their own each. An odd
// polynomial on [0, 1], by least squares at Chebyshev's points, within 1e-7.
fn angle_of(y : f32, x : f32) -> f32 {
  let wide = max(abs(x), abs(y));
  if (wide == 0.0) { return 0.0; }
  let t = min(abs(x), abs(y)) / wide;
  let s = t * t;
  var p = kAtan[0];
  for (var k = 1u; k < 8u; k++) { p = p * s + kAtan[k]; }
  var angle = t * s * p + t;
  if (abs(y) > abs(x)) { angle = 1.57079632679 - angle; }
  if (x < 0.0) { angle = 3.14159265359 - angle; }
  return select(angle, -angle, y < 0.0);
}

struct Wing {
  edge : vec3f,    // from a to b, m
  first : vec3f,   // twice the area of a b c, m²
  second : vec3f,  // twice that of b a d
  c : vec3f,       // from a, m
  d : vec3f,
}
fn wing_of(a : vec3f, b : vec3f, c : vec3f, d : vec3f) -> Wing {
  let edge = b - a;
  return Wing(edge, cross(edge, c - a), cross(d - a, edge), c - a, d - a);
}

fn hinge_angle(w : Wing) -> f32 {
  return angle_of(dot(cross(w.second, w.first), w.edge), length(w.edge) * dot(w.first, w.second));
}

struct HingeSlope {  // 1/m
  b : vec3f,
  c : vec3f,
  d : vec3f,  // a has what makes the sum zero
}
// How fast the angle changes where the corners move so fast, or by how much where they move so far.
fn hinge_change(slope : HingeSlope, a : vec3f, b : vec3f, c : vec3f, d : vec3f) -> f32 {
  return dot(slope.b, b - a) + dot(slope.c, c - a) + dot(slope.d, d - a);
}

fn hinge_slope(w : Wing) -> HingeSlope {
  let square = max(dot(w.edge, w.edge), kMinArea);
  let span = sqrt(square);
  let at_c = span / max(dot(w.first, w.first), kMinArea * kMinArea) * w.first;
  let at_d = span / max(dot(w.second, w.second), kMinArea * kMinArea) * w.second;
  let foot_c = dot(w.c, w.edge) / square;
  let foot_d = dot(w.d, w.edge) / square;
  return HingeSlope(-foot_c * at_c - foot_d * at_d, at_c, at_d);
}
