// How far two motions from one start have come apart.
#pragma once

#include <cmath>
#include <vector>

#include "base/vec.hpp"

namespace weft {

/// RMS |a - b| / RMS |b - start|.
inline double relative_error(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b,
                             const std::vector<Vec3d>& start) {
  double error = 0, way = 0;
  for (std::size_t n = 0; n < b.size(); ++n) {
    const Vec3d apart = a[n] - b[n], went = b[n] - start[n];
    error += dot(apart, apart);
    way += dot(went, went);
  }
  return std::sqrt(error / way);
}

}  // namespace weft
