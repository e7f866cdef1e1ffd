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

const kLeast = 1e-37;  // in place of zero, of what is divided by

// The cross product of u and v, square to both within the rounding of lengths, however small their angle: with what of
// v is square to u. Where closest points are inside, `apart` has its direction, and separates all of one feature from
// all of the other: what is between the places does so to the rounding over the sine of that angle only.
fn square_to(u : vec3f, v : vec3f) -> vec3f { return cross(u, v - dot(u, v) / max(dot(u, u), kLeast) * u); }

fn closest_on_triangle(p : vec3f, a : vec3f, b : vec3f, c : vec3f) -> Closest {
  let ab = b - a;
  let ac = c - a;
  let ap = p - a;
  let n = square_to(ab, ac);
  let area = dot(n, n);
  let s = dot(cross(ap, ac), n);
  let t = dot(cross(ab, ap), n);
  if (s >= 0.0 && t >= 0.0 && s + t <= area && area > 0.0) {
    let u = s / area;
    let v = t / area;
    return Closest(u, v, dot(n, ap) / area * n, true);
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
const kParallel = 1e-10;  // the square of the sine of the angle between them
fn closest_on_edges(a : vec3f, b : vec3f, c : vec3f, d : vec3f) -> Closest {
  let u = b - a;
  let v = d - c;
  let r = a - c;
  let uu = dot(u, u);
  let vv = dot(v, v);
  let uv = dot(u, v);
  let ur = dot(u, r);
  let vr = dot(v, r);
  let n = square_to(u, v);
  let nn = dot(n, n);
  // No short circuit: SwiftShader takes all memory to compile its branches.
  let cross_over = (nn > kParallel * uu * vv) & (nn > 0.0);
  var s = select(0.0, clamp(dot(cross(v, r), n) / max(nn, kLeast), 0.0, 1.0), cross_over);
  let free = (uv * s + vr) / max(vv, kLeast);
  let t = clamp(free, 0.0, 1.0);
  s = select(s, clamp((uv * t - ur) / max(uu, kLeast), 0.0, 1.0), (t != free) | (vv <= 0.0));
  let inside = cross_over & (s > 0.0) & (s < 1.0) & (t > 0.0) & (t < 1.0);
  return Closest(s, t, select(r + s * u - t * v, dot(n, r) / max(nn, kLeast) * n, inside), inside);
}

// Of a pair: two edges, or a vertex and a triangle.
fn closest_of_pair(edges : bool, a : vec3f, b : vec3f, c : vec3f, d : vec3f) -> Closest {
  if (edges) { return closest_on_edges(a, b, c, d); }
  return closest_on_triangle(a, b, c, d);
}
