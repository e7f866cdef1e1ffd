// On which side of a plane a point lies, exactly.
#pragma once

#include "base/vec.hpp"

namespace weft::mesh {

/// The sign of (b - a) x (c - a) . (p - a): 1 above the triangle that is seen counter-clockwise, -1 below it,
/// 0 in its plane. Exact for coordinates below 1e100 whose products do not underflow: where rounding could
/// turn the sign, the determinant's terms are summed without any. Source: Shewchuk 1997, Adaptive Precision
/// Floating-Point Arithmetic and Fast Robust Geometric Predicates.
int orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p);

}  // namespace weft::mesh
