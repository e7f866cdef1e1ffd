// A symmetric 3 x 3 matrix.
#pragma once

#include "base/mat3.hpp"

namespace weft::reference {

struct Sym3 {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  Sym3& operator+=(const Sym3& b) { return *this = *this + b; }
  friend Sym3 operator+(const Sym3& a, const Sym3& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
  }
  friend Sym3 operator*(double s, const Sym3& a) {
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
  }
  friend Vec3d operator*(const Sym3& a, const Vec3d& v) {
    return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
            a.xz * v.x + a.yz * v.y + a.zz * v.z};
  }
  double trace() const { return xx + yy + zz; }

  static Sym3 identity(double s) { return {s, 0, 0, s, 0, s}; }
  /// (A + Aᵀ) / 2
  static Sym3 symmetric_part(const Mat3& a) {
    return {a.x.x, (a.x.y + a.y.x) / 2, (a.x.z + a.z.x) / 2, a.y.y, (a.y.z + a.z.y) / 2, a.z.z};
  }
  /// s n nᵀ
  static Sym3 outer(const Vec3d& n, double s) {
    return {s * n.x * n.x, s * n.x * n.y, s * n.x * n.z, s * n.y * n.y, s * n.y * n.z, s * n.z * n.z};
  }
};

/// The inverse; of a matrix whose determinant is not positive, 0.
inline Sym3 inverse(const Sym3& a) {
  const Sym3 c{a.yy * a.zz - a.yz * a.yz, a.xz * a.yz - a.xy * a.zz, a.xy * a.yz - a.xz * a.yy,
               a.xx * a.zz - a.xz * a.xz, a.xy * a.xz - a.xx * a.yz, a.xx * a.yy - a.xy * a.xy};
  const double det = a.xx * c.xx + a.xy * c.xy + a.xz * c.xz;
  if (!(det > 0)) return {};
  return (1 / det) * c;
}

}  // namespace weft::reference
