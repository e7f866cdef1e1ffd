// A flat sheet rolled to a cylinder.
#pragma once

#include <cmath>
#include <vector>

#include "closed_forms/pattern_sheet.hpp"

namespace weft {

/// Without a stretch; `direction` is the angle of the curvature to x [rad]; the curvature may be 0.
inline std::vector<Vec3d> rolled(const PatternSheet& sheet, double curvature, double direction) {
  const Vec3d along{std::cos(direction), std::sin(direction), 0}, across{-along.y, along.x, 0};
  std::vector<Vec3d> x;
  for (const Vec3d& p : sheet.position) {
    const double way = dot(p, along), turn = curvature * way;
    const double chord = curvature == 0 ? way : std::sin(turn) / curvature;
    const double rise = curvature == 0 ? 0 : 2 * std::pow(std::sin(turn / 2), 2) / curvature;
    x.push_back(chord * along + dot(p, across) * across + Vec3d{0, 0, rise});
  }
  return x;
}

}  // namespace weft
