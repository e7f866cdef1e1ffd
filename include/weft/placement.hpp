#pragma once

#include <array>
#include <span>

#include "weft/result.hpp"
#include "weft/vec.hpp"

namespace weft {

/// Where a rigid thing is, from where its scene puts it: p' = R p + position, R by a unit quaternion.
struct Placement {
  Vec3d position;                              // [m]
  std::array<double, 4> rotation{0, 0, 0, 1};  // x, y, z, w
  bool operator==(const Placement&) const = default;

  /// Of a 4 x 4 matrix, column by column as WebGPU, glTF and three.js have it.
  /// Errors  Input: a number is not finite; the last row is not 0, 0, 0, 1; it scales, shears or mirrors.
  static Result<Placement> from_matrix(std::span<const double, 16> columns);
};

}  // namespace weft
