// 4 x 4 matrices for cameras: columns, as WGSL has them; made in double, handed over in float.
#pragma once

#include <array>

#include "base/vec.hpp"

namespace weft::render {

struct Mat4d {
  std::array<double, 16> m{};  // m[4 * column + row]

  double& at(int row, int column) { return m[static_cast<std::size_t>(4 * column + row)]; }
  double at(int row, int column) const { return m[static_cast<std::size_t>(4 * column + row)]; }

  friend Mat4d operator*(const Mat4d& a, const Mat4d& b) {
    Mat4d product;
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        for (int k = 0; k < 4; ++k) product.at(row, column) += a.at(row, k) * b.at(k, column);
    return product;
  }
  std::array<float, 16> to_float() const {
    std::array<float, 16> values{};
    for (std::size_t i = 0; i < 16; ++i) values[i] = static_cast<float>(m[i]);
    return values;
  }
  /// A point [m] to clip space: x, y, z, w.
  std::array<double, 4> apply(const Vec3d& p) const {
    std::array<double, 4> clip{};
    for (int row = 0; row < 4; ++row)
      clip[static_cast<std::size_t>(row)] =
          at(row, 0) * p.x + at(row, 1) * p.y + at(row, 2) * p.z + at(row, 3);
    return clip;
  }
};

}  // namespace weft::render
