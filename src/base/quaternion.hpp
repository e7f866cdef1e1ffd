// Rotations as unit quaternions.
#pragma once

#include <array>

#include "base/mat3.hpp"

namespace weft {

/// A unit quaternion x, y, z, w.
using Quaternion = std::array<double, 4>;
Quaternion product(const Quaternion& a, const Quaternion& b);
/// Of the turn back.
inline Quaternion conjugate(const Quaternion& q) { return {-q[0], -q[1], -q[2], q[3]}; }
Mat3 matrix_of(const Quaternion& q);
/// Of a rotation.
Quaternion quaternion_of(const Mat3& rotation);

}  // namespace weft
