// How fast the stress of a tetrahedron turns: tet_turning.wgsl in double. Source: docs/solvers/xpbd.md, equation 17.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/mat3.hpp"
#include "element/tet/law.hpp"

namespace weft::reference {

/// No eigenvalue of a symmetric matrix is larger: Gershgorin.
inline double largest_at_most(const Mat3& a) {
  return std::max({a.x.x + std::abs(a.x.y) + std::abs(a.x.z), a.y.y + std::abs(a.y.x) + std::abs(a.y.z),
                   a.z.z + std::abs(a.z.x) + std::abs(a.z.y)});
}

/// How fast a stress grows at most as F = R `stretch` turns, where it is R `stress`.
inline double turning(const Mat3& stretch, const Mat3& stress) {
  const double pull = largest_at_most(Mat3::identity(trace(stress)) + -1.0 * stress);
  const double lever = -largest_at_most(stretch + Mat3::identity(-trace(stretch)));
  return std::max(0.0, pull) / std::max(1.0, lever);
}

/// What damping pulls with where F was `start` a delay ago [Pa]: docs/solvers/projective_dynamics.md, equation 17.
inline Mat3 delayed_stress(const tet::Law& law, const Mat3& start, const Mat3& f, const Mat3& rotation) {
  const Mat3 begun = tet::nearest_rotation(f * transposed(start)) * start;
  const double grown = contraction(rotation, f) - contraction(tet::nearest_rotation(start), start);
  return 2 * law.mu * (f + -1.0 * begun) + law.lambda * grown * rotation;
}

}  // namespace weft::reference
