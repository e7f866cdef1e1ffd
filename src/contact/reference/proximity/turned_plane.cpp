#include "contact/reference/proximity/turned_plane.hpp"

#include <algorithm>

#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/proximity/separate.hpp"
#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

constexpr double kLeast = 1e-300;  // in place of zero, of what is divided by

/// How far A is beyond B along a direction [m].
double apart_along(const MovingPair& pair, const std::array<Vec3d, 4>& at, const Vec3d& direction) {
  BothSides sides{pair.count_a, pair.count_b};
  for (std::uint32_t k = 0; k < 4; ++k) sides.along[k] = dot(direction, at[k]);
  return sides.apart();
}

/// Of two edges, or of the triangle.
Vec3d normal_of_features(const MovingPair& pair) {
  const std::array<Vec3d, 4>& at = pair.start;
  return cross(at[1] - at[pair.count_a == 2 ? 0 : 2], at[3] - at[2]);
}

}  // namespace

Vec3d turned_normal(const MovingPair& pair, const Vec3d& normal, double distance, double margin) {
  double longest = 0;
  for (std::uint32_t k = 0; k < 4; ++k) longest = std::max(longest, length(pair.end[k] - pair.start[k]));
  if (longest < kTurningWay * distance) return normal;
  const Vec3d offset = offset_between(pair.count_a, pair.count_b, pair.end),
              across = normal_of_features(pair);
  const Vec3d then = (1 / std::max(length(offset), kLeast)) * offset;
  Vec3d best = normal;
  double farthest = apart_along(pair, pair.end, normal);
  for (const Vec3d& direction : {dot(across, normal) > 0 ? across : -across, then, normal + then}) {
    const Vec3d unit = (1 / std::max(length(direction), kLeast)) * direction;
    const double at_end = apart_along(pair, pair.end, unit);
    if (!(apart_along(pair, pair.start, unit) >= margin) || at_end <= farthest) continue;
    best = unit;
    farthest = at_end;
  }
  return best;
}

}  // namespace weft::reference
