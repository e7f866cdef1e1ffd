#include "closed_forms/rope_over_capsule.hpp"

#include <algorithm>
#include <cmath>

namespace weft {

/// Along the capsule, from the left end on, with N = (T / λ - v²) / R + g sin θ, T over the rope's mass per length:
/// dT/dθ = μ R N + R (a + g cos θ), T(0) = (g + a) L, T(π) = (g - a) L'. What is left of that is linear in a.
double RopeOverCapsule::acceleration(double way, double speed) const {
  constexpr int kParts = 400;
  const double width = std::acos(-1.0) / kParts;
  const auto beyond = [&](double a) {
    double tension = (gravity + a) * (left - way);
    for (int k = 0; k < kParts; ++k) {
      const double angle = (k + 0.5) * width;
      const auto rate = [&](double t) {
        return friction * (t - speed * speed + gravity * radius * std::sin(angle)) +
               radius * (a + gravity * std::cos(angle));
      };
      tension += width * rate(tension + 0.5 * width * rate(tension));
    }
    return tension - (gravity - a) * (right + way);
  };
  return -beyond(0) / (beyond(1) - beyond(0));
}

double RopeOverCapsule::way(double time) const {
  constexpr double kStep = 1e-3;
  double way = 0, speed = 0;
  for (double t = 0; t < time; t += kStep) {
    speed = std::max(0.0, speed + kStep * acceleration(way, speed));
    way += kStep * speed;
  }
  return way;
}

}  // namespace weft
