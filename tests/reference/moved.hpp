// Vertices that move in a substep, and what their motion has.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/proximity/truncate.hpp"

namespace weft::reference {

/// The ways of some vertices in a substep, each with the velocity of its way in a second.
struct Moved {
  std::vector<Vec3d> start, end, velocity_before, velocity;
  std::vector<double> inverse_mass;

  void add(const Vec3d& from, const Vec3d& to, double inverse = 1) {
    start.push_back(from);
    end.push_back(to);
    velocity_before.push_back(to - from);
    velocity.push_back(to - from);
    inverse_mass.push_back(inverse);
  }
  Truncated cut(const std::vector<SolidPlane>& planes, const std::vector<ClothPair>& pairs, double reach,
                std::uint32_t separations = 0, std::uint64_t most_delay = 0) {
    return truncate(planes, pairs, reach,
                    {start, inverse_mass, end, velocity, 1, separations, {}, most_delay, velocity_before});
  }
  Vec3d momentum() const {
    Vec3d sum;
    for (std::size_t i = 0; i < velocity.size(); ++i)
      if (inverse_mass[i] > 0) sum += velocity[i] / inverse_mass[i];
    return sum;
  }
  /// How near two vertices come on their ways [m].
  double nearest(std::uint32_t a, std::uint32_t b) const {
    return closest_on_segment({}, start[a] - start[b], end[a] - end[b]).distance;
  }
  double kinetic() const {
    double sum = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i)
      if (inverse_mass[i] > 0) sum += 0.5 * dot(velocity[i], velocity[i]) / inverse_mass[i];
    return sum;
  }
};

}  // namespace weft::reference
