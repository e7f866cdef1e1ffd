// The second derivative of the angle at an edge. In double. Source: docs/elements.md, The reference.
#pragma once

#include "base/mat3.hpp"
#include "element/hinge/law.hpp"

namespace weft::hinge {

using AngleHessian = std::array<std::array<Mat3, 4>, 4>;  // by corners a, b, c, d [1/m²]

/// What one triangle has of the angle's slope is w_i u: with e = b - a, p = c - a and n = e x p, the vector u = |e|
/// n/|n|² is the normal by the height, f = p·e/|e|² the foot of c on the edge, and w = (f - 1, -f, 1). It depends on
/// the triangle's own corners only, so that the Hessian is a sum over both:
///   ∂u/∂e = n eᵀ/(|e| |n|²) - U [p],  ∂u/∂p = U [e],  U = |e| (I/|n|² - 2 n nᵀ/|n|⁴),  [a] v = a x v
///   ∂f/∂e = (p - 2 f e)/|e|²,         ∂f/∂p = e/|e|²
inline std::array<std::array<Mat3, 3>, 3> slope_change(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d e = b - a, p = c - a, n = cross(e, p);
  const double span = length(e), ee = dot(e, e), nn = dot(n, n), foot = dot(p, e) / ee;
  const Vec3d u = span / nn * n;
  const Mat3 by_n = span / nn * (Mat3::identity(1) + -2 / nn * Mat3::outer(n, n));
  const Mat3 u_e = 1 / (span * nn) * Mat3::outer(n, e) + -1.0 * (by_n * Mat3::cross(p)),
             u_p = by_n * Mat3::cross(e);
  const Vec3d f_e = (p - 2 * foot * e) / ee, f_p = e / ee;
  const std::array<double, 3> weight = {foot - 1, -foot, 1}, by_foot = {1, -1, 0};
  std::array<std::array<Mat3, 3>, 3> change;
  for (std::size_t i = 0; i < 3; ++i) {
    change[i][1] = weight[i] * u_e + by_foot[i] * Mat3::outer(u, f_e);
    change[i][2] = weight[i] * u_p + by_foot[i] * Mat3::outer(u, f_p);
    change[i][0] = -1.0 * (change[i][1] + change[i][2]);
  }
  return change;
}

inline AngleHessian angle_hessian(const Corners& x) {
  constexpr std::array<std::array<std::size_t, 3>, 2> kTriangles = {{{0, 1, 2}, {1, 0, 3}}};
  AngleHessian all;
  for (const auto& corners : kTriangles) {
    const auto change = slope_change(x[corners[0]], x[corners[1]], x[corners[2]]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) all[corners[i]][corners[j]] += change[i][j];
  }
  return all;
}

}  // namespace weft::hinge
