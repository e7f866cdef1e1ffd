// Whether a segment passes through a triangle: its ends lie on two sides of the triangle, and the triangle's edges pass it on
// one and the same side. Touching is not crossing. Source: signed volumes, as in Segura and Feito 2001.
fn volume(a : vec3f, b : vec3f, c : vec3f) -> f32 { return dot(a, cross(b, c)); }

fn crosses(p : vec3f, q : vec3f, a : vec3f, b : vec3f, c : vec3f) -> bool {
  let from_p = volume(a - p, b - p, c - p);
  let from_q = volume(a - q, b - q, c - q);
  if (from_p == 0.0 || from_q == 0.0 || (from_p > 0.0) == (from_q > 0.0)) { return false; }
  let d = q - p;
  let ab = volume(d, a - p, b - p);
  let bc = volume(d, b - p, c - p);
  let ca = volume(d, c - p, a - p);
  return (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
}
