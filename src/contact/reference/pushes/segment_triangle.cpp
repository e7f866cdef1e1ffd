#include "contact/reference/pushes/segment_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weft::reference {
namespace {

constexpr double kSegmentRounding = 64.0 / (1U << 24U);

double largest_of(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// f32's test x >= 0 with tolerance t.
Verdict at_least_zero(double x, double t) {
  return x >= 0 ? Verdict::Hit : x < -2 * t ? Verdict::Miss : Verdict::Ambiguous;
}
/// f32's test x > 0 with tolerance t.
Verdict above_zero(double x, double t) {
  return x > 2 * t ? Verdict::Hit : x <= 0 ? Verdict::Miss : Verdict::Ambiguous;
}

Verdict both(Verdict a, Verdict b) { return std::min(a, b); }    // "and": one certain miss is a miss
Verdict either(Verdict a, Verdict b) { return std::max(a, b); }  // "or": one certain hit is a hit

struct Determinants {
  double a, ua, va, ta;
};
struct Tolerances {
  double a, u, v, t;
};

Verdict inside(const Determinants& d, const Tolerances& t) {
  Verdict verdict = at_least_zero(d.ua, t.u);
  verdict = both(verdict, at_least_zero(d.va, t.v));
  verdict = both(verdict, at_least_zero(d.a - d.ua - d.va, 3 * std::max({t.u, t.v, t.a})));
  verdict = both(verdict, above_zero(d.ta, t.t));
  return both(verdict, above_zero(d.a - d.ta, 2 * std::max(t.t, t.a)));
}

}  // namespace

Verdict segment_triangle(const Vec3d& from, const Vec3d& to, const TrianglePoints& triangle) {
  const Vec3d d = to - from, s = from - triangle.a;
  const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
  const Vec3d p = cross(d, e2), q = cross(s, e1);
  const Determinants positive{dot(e1, p), dot(s, p), dot(d, q), dot(e2, q)};
  const Determinants negative{-positive.a, -positive.ua, -positive.va, -positive.ta};
  const double size_s = kSegmentRounding * largest_of(s), size_d = largest_of(d), size_1 = largest_of(e1),
               size_2 = largest_of(e2);
  const Tolerances t{kSegmentRounding * size_d * size_1 * size_2, size_s * size_d * size_2,
                     size_s * size_d * size_1, size_s * size_1 * size_2};
  // Within 15/64 of the tolerance no error lifts |a| above it; within twice the tolerance its sign may be
  // lost.
  if (std::abs(positive.a) <= 0.2 * t.a) return Verdict::Miss;
  if (std::abs(positive.a) <= 2 * t.a)
    return both(Verdict::Ambiguous, either(inside(positive, t), inside(negative, t)));
  return inside(positive.a > 0 ? positive : negative, t);
}

Verdict triangle_pair(const TrianglePoints& a, const TrianglePoints& b) {
  Verdict verdict = Verdict::Miss;
  for (const auto& [from, onto] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    verdict = either(verdict, segment_triangle(from->a, from->b, *onto));
    verdict = either(verdict, segment_triangle(from->b, from->c, *onto));
    verdict = either(verdict, segment_triangle(from->c, from->a, *onto));
  }
  return verdict;
}

}  // namespace weft::reference
