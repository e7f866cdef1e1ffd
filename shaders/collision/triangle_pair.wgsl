// Whether two triangles intersect: each edge of either against the other by the extended Moeller-Trumbore test
// (Sung et al., section on collision), without division or root. docs/collision.md has the equations.
//
// For the segment S + t d, 0 < t < 1, and the triangle V0, V0 + e1, V0 + e2, with s = S - V0, the hit is at
//   a = e1 . (d x e2),   u a = s . (d x e2),   v a = d . (s x e1),   t a = e2 . (s x e1).
// u = 0, v = 0 and u + v = 1 hit; t = 0, t = 1 and a = 0 (parallel) miss.
//
// Tolerance. Each of the four is a sum of six products x_i y_j z_k of components of three vectors. Each component is a
// difference of two f32, rounded once (3 roundings a product); the product is rounded twice, the difference in the
// cross product once, the two sums of the dot product twice: 8 factors (1 + e), |e| <= 2^-24. With M the product of
// the three vectors' largest components as rounded, the error is at most 6 M ((1 + e)^5 / (1 - e)^3 - 1) < 49 * 2^-24 M.
// kRounding is 64 * 2^-24, the next power of two: room for the rounding of M itself. A sum of n determinants has n times
// the largest of their tolerances. On integer coordinates every value is exact below 2^24, so where the tolerances are
// below 1 the test equals the exact one: true if no difference of coordinates exceeds 44 (3 * 64 * 2^-24 * 44^3 = 0.97).
//
// All products are added by fma(), and tolerances are products only: with `a * b + c` a compiler may or may not fuse, and
// might choose differently in two kernels; here nothing is left to choose, so `paper` and `bvh` see the same bits.
const kRounding = 3.814697265625e-06;  // 64 * 2^-24

struct TrianglePoints { a : vec3f, b : vec3f, c : vec3f }
struct Box { low : vec3f, high : vec3f }

fn cross_fused(a : vec3f, b : vec3f) -> vec3f { return fma(a.yzx, b.zxy, -(a.zxy * b.yzx)); }
fn dot_fused(a : vec3f, b : vec3f) -> f32 { return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x)); }
fn largest(a : vec3f) -> f32 { return max(max(abs(a.x), abs(a.y)), abs(a.z)); }

fn segment_hits(s : vec3f, d : vec3f, e1 : vec3f, e2 : vec3f) -> bool {
  let p = cross_fused(d, e2);
  let q = cross_fused(s, e1);
  let det = dot_fused(e1, p);
  let side = select(-1.0, 1.0, det >= 0.0);
  let a = abs(det);
  let ua = side * dot_fused(s, p);
  let va = side * dot_fused(d, q);
  let ta = side * dot_fused(e2, q);
  let size_s = kRounding * largest(s);
  let size_d = largest(d);
  let size_1 = largest(e1);
  let size_2 = largest(e2);
  let tolerance_a = kRounding * size_d * (size_1 * size_2);
  let tolerance_u = size_s * (size_d * size_2);
  let tolerance_v = size_s * (size_d * size_1);
  let tolerance_t = size_s * (size_1 * size_2);
  return a > tolerance_a && ua >= -tolerance_u && va >= -tolerance_v && ta > tolerance_t &&
         (ua + va) - a <= 3.0 * max(max(tolerance_u, tolerance_v), tolerance_a) &&
         a - ta > 2.0 * max(tolerance_t, tolerance_a);
}

fn edges_hit(edges : TrianglePoints, face : TrianglePoints) -> bool {
  let e1 = face.b - face.a;
  let e2 = face.c - face.a;
  return segment_hits(edges.a - face.a, edges.b - edges.a, e1, e2) ||
         segment_hits(edges.b - face.a, edges.c - edges.b, e1, e2) ||
         segment_hits(edges.c - face.a, edges.a - edges.c, e1, e2);
}

fn box_of(t : TrianglePoints) -> Box { return Box(min(min(t.a, t.b), t.c), max(max(t.a, t.b), t.c)); }

// The box of a cloth triangle, grown by 2^-21 of its largest coordinate: 8 to 16 steps of f32 there, so that a hit that
// stands only by the tolerance above is kept. The product with a power of two is exact, so fusing cannot change it.
fn query_box(t : TrianglePoints) -> Box {
  let box = box_of(t);
  let growth = vec3f(largest(max(abs(box.low), abs(box.high))) * 4.76837158203125e-07);
  return Box(box.low - growth, box.high + growth);
}

fn boxes_overlap(query : Box, box : Box) -> bool {
  return all(query.low <= box.high) && all(box.low <= query.high);
}

// A pair counts if its boxes overlap and an edge hits. That makes the tree's pairs those of brute force, for:
// min, max and comparison are exact, so a tree node's box contains the boxes of its triangles as numbers, and whatever
// overlaps a triangle's box overlaps the boxes of all nodes above it. Hence the tree reaches every pair whose boxes
// overlap, and both methods then ask the same function. Nothing true is lost: triangles with a common point have boxes
// with a common point, grown or not.
fn triangles_intersect(cloth : TrianglePoints, query : Box, object : TrianglePoints) -> bool {
  return boxes_overlap(query, box_of(object)) && (edges_hit(cloth, object) || edges_hit(object, cloth));
}

// Found on the bits: a compiler may take NaN and infinity to be absent.
fn is_finite(v : vec3f) -> bool {
  return all((bitcast<vec3u>(v) & vec3u(0x7f800000u)) != vec3u(0x7f800000u));
}
