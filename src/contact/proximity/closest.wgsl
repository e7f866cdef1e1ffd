// Closest points of features, robust where they are degenerate: no division by a number that can be zero.
// Source: Ericson, Real-Time Collision Detection, 5.1; the inside of a triangle by areas, all other regions by its
// edges.

struct Closest {
  s : f32,             // vertex and triangle: the weights of its second and third corner; edges: the place on either
  t : f32,
  apart : vec3f,       // p_A - p_B, m
  inside : bool,       // edges: both closest points are between the ends
}

// The place on a segment that is nearest to p, from 0 at a to 1 at a + d.
fn place_on_segment(p : vec3f, a : vec3f, d : vec3f) -> f32 {
  let size = dot(d, d);
  if (size <= 0.0) { return 0.0; }
  return clamp(dot(p - a, d) / size, 0.0, 1.0);
}

fn closest_on_triangle(p : vec3f, a : vec3f, b : vec3f, c : vec3f) -> Closest {
  let ab = b - a;
  let ac = c - a;
  let ap = p - a;
  let n = cross(ab, ac);
  let area = dot(n, n);
  let s = dot(cross(ap, ac), n);
  let t = dot(cross(ab, ap), n);
  if (s >= 0.0 && t >= 0.0 && s + t <= area && area > 0.0) {
    let u = s / area;
    let v = t / area;
    return Closest(u, v, ap - u * ab - v * ac, true);
  }
  let on_ab = place_on_segment(p, a, ab);
  let on_ac = place_on_segment(p, a, ac);
  let bc = c - b;
  let on_bc = place_on_segment(p, b, bc);
  let from_ab = ap - on_ab * ab;
  let from_ac = ap - on_ac * ac;
  let from_bc = (p - b) - on_bc * bc;
  let size_ab = dot(from_ab, from_ab);
  let size_ac = dot(from_ac, from_ac);
  let size_bc = dot(from_bc, from_bc);
  if (size_ab <= size_ac && size_ab <= size_bc) { return Closest(on_ab, 0.0, from_ab, true); }
  if (size_ac <= size_bc) { return Closest(0.0, on_ac, from_ac, true); }
  return Closest(1.0 - on_bc, on_bc, from_bc, true);
}

// Of the segments from a to b and from c to d. Parallel ones take the first's start, so they are never inside.
fn closest_on_edges(a : vec3f, b : vec3f, c : vec3f, d : vec3f) -> Closest {
  let u = b - a;
  let v = d - c;
  let r = a - c;
  let uu = dot(u, u);
  let vv = dot(v, v);
  let uv = dot(u, v);
  let ur = dot(u, r);
  let vr = dot(v, r);
  let size = uu * vv;
  let det = size - uv * uv;
  var s = 0.0;
  if (det > 1e-6 * size && det > 0.0) { s = clamp((uv * vr - ur * vv) / det, 0.0, 1.0); }
  var t = 0.0;
  if (vv > 0.0) {
    let free = (uv * s + vr) / vv;
    t = clamp(free, 0.0, 1.0);
    if (t != free && uu > 0.0) { s = clamp((uv * t - ur) / uu, 0.0, 1.0); }
  } else if (uu > 0.0) {
    s = clamp(-ur / uu, 0.0, 1.0);
  }
  let inside = s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0;
  return Closest(s, t, r + s * u - t * v, inside);
}
