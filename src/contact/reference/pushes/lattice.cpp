#include "contact/reference/pushes/lattice.hpp"

#include <algorithm>

namespace weft::reference {
namespace {

LatticePoint minus(const LatticePoint& a, const LatticePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// x . (y x z)
std::int64_t determinant(const LatticePoint& x, const LatticePoint& y, const LatticePoint& z) {
  return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
         x[2] * (y[0] * z[1] - y[1] * z[0]);
}

}  // namespace

bool segment_meets(const LatticePoint& from, const LatticePoint& to, const LatticeTriangle& triangle) {
  const LatticePoint d = minus(to, from), s = minus(from, triangle[0]);
  const LatticePoint e1 = minus(triangle[1], triangle[0]), e2 = minus(triangle[2], triangle[0]);
  const std::int64_t a = determinant(e1, d, e2);
  if (a == 0) return false;
  const std::int64_t side = a > 0 ? 1 : -1;
  const std::int64_t u = side * determinant(s, d, e2);
  const std::int64_t v = side * determinant(d, s, e1);
  const std::int64_t t = side * determinant(e2, s, e1);
  return u >= 0 && v >= 0 && u + v <= side * a && t > 0 && t < side * a;
}

bool triangles_meet(const LatticeTriangle& a, const LatticeTriangle& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (segment_meets(a[k], a[(k + 1) % 3], b) || segment_meets(b[k], b[(k + 1) % 3], a)) return true;
  return false;
}

}  // namespace weft::reference
