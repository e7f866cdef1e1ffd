// A 3 x 3 matrix in double.
#pragma once

#include "base/vec.hpp"

namespace weft {

struct Mat3 {
  Vec3d x, y, z;  // rows

  bool operator==(const Mat3&) const = default;
  Mat3& operator+=(const Mat3& b) { return *this = *this + b; }
  friend Mat3 operator+(const Mat3& a, const Mat3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Mat3 operator*(double s, const Mat3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Vec3d operator*(const Mat3& a, const Vec3d& v) { return {dot(a.x, v), dot(a.y, v), dot(a.z, v)}; }

  static Mat3 identity(double s) { return {{s, 0, 0}, {0, s, 0}, {0, 0, s}}; }
  /// a bᵀ
  static Mat3 outer(const Vec3d& a, const Vec3d& b) { return {a.x * b, a.y * b, a.z * b}; }
  /// v -> a x v
  static Mat3 cross(const Vec3d& a) { return {{0, -a.z, a.y}, {a.z, 0, -a.x}, {-a.y, a.x, 0}}; }
};

inline Mat3 transposed(const Mat3& a) {
  return {{a.x.x, a.y.x, a.z.x}, {a.x.y, a.y.y, a.z.y}, {a.x.z, a.y.z, a.z.z}};
}

inline Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Mat3 t = transposed(b);
  return {t * a.x, t * a.y, t * a.z};
}

inline double trace(const Mat3& a) { return a.x.x + a.y.y + a.z.z; }
/// Σ a_ij b_ij
inline double contraction(const Mat3& a, const Mat3& b) {
  return dot(a.x, b.x) + dot(a.y, b.y) + dot(a.z, b.z);
}
/// (A + Aᵀ) / 2
inline Mat3 symmetric_part(const Mat3& a) { return 0.5 * (a + transposed(a)); }
/// Of a matrix that has an inverse, that times its determinant, transposed.
inline Mat3 cofactor(const Mat3& a) { return {cross(a.y, a.z), cross(a.z, a.x), cross(a.x, a.y)}; }

/// Of a matrix that has one.
inline Mat3 inverse(const Mat3& a) {
  const Mat3 c = cofactor(a);
  return 1 / dot(a.x, c.x) * transposed(c);
}

}  // namespace weft
