#include "mesh/orientation.hpp"

#include <array>
#include <cmath>

#include "base/trig.hpp"

namespace weft::mesh {
namespace {

/// A sum without rounding: parts of rising size that do not overlap, so that the last decides the sign.
class ExactSum {
 public:
  void add(double term) {
    // Grow-expansion (Shewchuk, figure 6): each part takes the rounded sum and passes the error down.
    double carried = term;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const double sum = carried + parts_[i];
      const double part = sum - carried;
      const double error = (carried - (sum - part)) + (parts_[i] - part);
      carried = sum;
      if (error != 0) parts_[kept++] = error;
    }
    if (carried != 0) parts_[kept++] = carried;
    count_ = kept;
  }
  /// sign * x y z, in four parts.
  void add_product(double sign, double x, double y, double z) {
    const detail::Product xy = detail::exact_product(sign * x, y);
    for (const double factor : {xy.low, xy.high}) {
      const detail::Product part = detail::exact_product(factor, z);
      add(part.low);
      add(part.high);
    }
  }
  int sign() const { return count_ == 0 ? 0 : parts_[count_ - 1] > 0 ? 1 : -1; }

 private:
  std::array<double, 96> parts_{};  // 24 products of four parts each
  std::size_t count_ = 0;
};

/// x . (y x z) of the coordinates as they are, with no difference taken first.
void add_determinant(ExactSum& sum, double sign, const Vec3d& x, const Vec3d& y, const Vec3d& z) {
  sum.add_product(sign, x.x, y.y, z.z);
  sum.add_product(-sign, x.x, y.z, z.y);
  sum.add_product(sign, x.y, y.z, z.x);
  sum.add_product(-sign, x.y, y.x, z.z);
  sum.add_product(sign, x.z, y.x, z.y);
  sum.add_product(-sign, x.z, y.y, z.x);
}

}  // namespace

int orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) {
  const Vec3d u = b - a, v = c - a, w = p - a;
  const double determinant = dot(w, cross(u, v));
  const double size = std::abs(w.x) * (std::abs(u.y * v.z) + std::abs(u.z * v.y)) +
                      std::abs(w.y) * (std::abs(u.z * v.x) + std::abs(u.x * v.z)) +
                      std::abs(w.z) * (std::abs(u.x * v.y) + std::abs(u.y * v.x));
  constexpr double kError = 8.0 / (1ULL << 53U);  // of `size`: Shewchuk's bound is (7 + 56 eps) eps
  if (determinant > kError * size) return 1;
  if (determinant < -kError * size) return -1;
  if (size == 0) return 0;
  // The four points as rows (x, y, z, 1): the same is (b, c, p) - (a, c, p) + (a, b, p) - (a, b, c).
  ExactSum sum;
  add_determinant(sum, 1, b, c, p);
  add_determinant(sum, -1, a, c, p);
  add_determinant(sum, 1, a, b, p);
  add_determinant(sum, -1, a, b, c);
  return sum.sign();
}

}  // namespace weft::mesh
