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
// the three vectors' largest components as rounded, the error is at most 6 M ((1 + e)^5 / (1 - e)^3 - 1) < 49 * 2^-24
// M. kRounding is 64 * 2^-24, the next power of two: room for the rounding of M itself. A sum of n determinants has n
// times the largest of their tolerances. On integer coordinates every value is exact below 2^24, so where the
// tolerances are below 1 the test equals the exact one: true if no difference of coordinates exceeds 44 (3 * 64 * 2^-24
// * 44^3 = 0.97).
//
// All products are added by fma(), and tolerances are products only: with `a * b + c` a compiler may or may not fuse,
// and might choose differently in two kernels; here nothing is left to choose, so `paper` and `bvh` see the same bits.
#include "contact/geometry.wgsl"

struct TrianglePoints { a : vec3f, b : vec3f, c : vec3f }

fn cross_fused(a : vec3f, b : vec3f) -> vec3f { return fma(a.yzx, b.zxy, -(a.zxy * b.yzx)); }
fn dot_fused(a : vec3f, b : vec3f) -> f32 { return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x)); }

// Whether an edge of `edges` hits `face`. With n = e1 x e2 and w = s x d the determinants are
//   a = -d . n,   t a = s . n,   u a = e2 . w,   v a = -e1 . w:
// the same sums of six products, and n serves all three edges.
fn edges_hit(edges : TrianglePoints, face : TrianglePoints) -> bool {
  let e1 = face.b - face.a;
  let e2 = face.c - face.a;
  let n = cross_fused(e1, e2);
  let size_1 = largest(e1);
  let size_2 = largest(e2);
  let size_n = kRounding * (size_1 * size_2);
  let s0 = edges.a - face.a;
  let s1 = edges.b - face.a;
  let s2 = edges.c - face.a;
  let d0 = edges.b - edges.a;
  let d1 = edges.c - edges.b;
  let d2 = edges.a - edges.c;
  let det = -vec3f(dot_fused(d0, n), dot_fused(d1, n), dot_fused(d2, n));
  let side = select(vec3f(-1.0), vec3f(1.0), det >= vec3f(0.0));
  let a = abs(det);
  let ta = side * vec3f(dot_fused(s0, n), dot_fused(s1, n), dot_fused(s2, n));
  let size_s = vec3f(largest(s0), largest(s1), largest(s2));
  let size_d = vec3f(largest(d0), largest(d1), largest(d2));
  let tolerance_a = size_n * size_d;
  let tolerance_t = size_n * size_s;
  let crossing = (a > tolerance_a) & (ta > tolerance_t) & (a - ta > 2.0 * max(tolerance_t, tolerance_a));
  if (!any(crossing)) { return false; }

  let w0 = cross_fused(s0, d0);
  let w1 = cross_fused(s1, d1);
  let w2 = cross_fused(s2, d2);
  let ua = side * vec3f(dot_fused(e2, w0), dot_fused(e2, w1), dot_fused(e2, w2));
  let va = -side * vec3f(dot_fused(e1, w0), dot_fused(e1, w1), dot_fused(e1, w2));
  let size_w = kRounding * (size_s * size_d);
  let tolerance_u = size_w * size_2;
  let tolerance_v = size_w * size_1;
  let inside = (ua >= -tolerance_u) & (va >= -tolerance_v) &
               ((ua + va) - a <= 3.0 * max(max(tolerance_u, tolerance_v), tolerance_a));
  return any(crossing & inside);
}

fn box_of(t : TrianglePoints) -> Box { return Box(min(min(t.a, t.b), t.c), max(max(t.a, t.b), t.c)); }

// The box of a cloth triangle, grown by 2^-21 of its largest coordinate: 8 to 16 steps of f32 there, so that a hit that
// passes only by the tolerance above is kept. The product with a power of two is exact, so fusing cannot change it.
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
  return boxes_overlap(query, box_of(object)) && (edges_hit(cloth, object) | edges_hit(object, cloth));
}
