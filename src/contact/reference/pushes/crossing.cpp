#include "contact/reference/pushes/crossing.hpp"

#include <algorithm>
#include <cmath>

namespace weft::reference {
namespace {

constexpr double kRounding = 64.0 / (1U << 24U);  // of triangle_pair.wgsl
constexpr double kGrowth = 1.0 / (1U << 21U);

double largest(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The same determinants and tolerances as edges_hit of triangle_pair.wgsl; n = e1 x e2 serves all three
/// edges.
bool edges_cross(const TrianglePoints& edges, const TrianglePoints& face) {
  const Vec3d e1 = face.b - face.a, e2 = face.c - face.a;
  const Vec3d n = cross(e1, e2);
  const double size_1 = largest(e1), size_2 = largest(e2);
  const Vec3d* corners[] = {&edges.a, &edges.b, &edges.c, &edges.a};
  for (int k = 0; k < 3; ++k) {
    const Vec3d s = *corners[k] - face.a, d = *corners[k + 1] - *corners[k];
    const double determinant = -dot(d, n);
    const double side = determinant >= 0 ? 1 : -1;
    const double a = side * determinant, ta = side * dot(s, n);
    const double size_s = largest(s), size_d = largest(d);
    const double tolerance_a = kRounding * (size_1 * size_2) * size_d;
    const double tolerance_t = kRounding * (size_1 * size_2) * size_s;
    if (!(a > tolerance_a && ta > tolerance_t && a - ta > 2 * std::max(tolerance_t, tolerance_a))) continue;
    const Vec3d w = cross(s, d);
    const double ua = side * dot(e2, w), va = -side * dot(e1, w);
    const double tolerance_u = kRounding * (size_s * size_d) * size_2;
    const double tolerance_v = kRounding * (size_s * size_d) * size_1;
    if (ua >= -tolerance_u && va >= -tolerance_v &&
        ua + va - a <= 3 * std::max({tolerance_u, tolerance_v, tolerance_a}))
      return true;
  }
  return false;
}

}  // namespace

Box box_of(const TrianglePoints& t) { return {min(min(t.a, t.b), t.c), max(max(t.a, t.b), t.c)}; }

Box query_box(const TrianglePoints& cloth) {
  const Box box = box_of(cloth);
  const double growth = kGrowth * std::max(largest(box.low), largest(box.high));
  return {box.low - Vec3d{growth, growth, growth}, box.high + Vec3d{growth, growth, growth}};
}

bool triangles_cross(const TrianglePoints& a, const TrianglePoints& b) {
  return edges_cross(a, b) || edges_cross(b, a);
}

}  // namespace weft::reference
