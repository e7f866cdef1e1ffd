#include "closed_forms/rope_over_capsule.hpp"

#include <algorithm>
#include <cmath>

namespace weft {

/// Along the capsule, from the left end on, with N = (T / λ - v²) / R + g sin θ, T over the rope's mass per length:
/// dT/dθ = μ R N + R (a + g cos θ), T(0) = (g + a) L.
double RopeOverCapsule::tension(double angle, double acceleration, double way, double speed) const {
  constexpr int kParts = 400;
  const double width = angle / kParts;
  double tension = (gravity + acceleration) * (left - way);
  for (int k = 0; k < kParts; ++k) {
    const double at = (k + 0.5) * width;
    const auto rate = [&](double t) {
      return friction * (t - speed * speed + gravity * radius * std::sin(at)) +
             radius * (acceleration + gravity * std::cos(at));
    };
    tension += width * rate(tension + 0.5 * width * rate(tension));
  }
  return tension;
}

/// T(π) = (g - a) L'. What is left of that is linear in a.
double RopeOverCapsule::acceleration(double way, double speed) const {
  const auto beyond = [&](double a) {
    return tension(std::acos(-1.0), a, way, speed) - (gravity - a) * (right + way);
  };
  return -beyond(0) / (beyond(1) - beyond(0));
}

double RopeOverCapsule::way(double time, double speed) const {
  constexpr double kStep = 1e-3;
  double way = 0;
  for (double t = 0; t < time; t += kStep) {
    speed = std::max(0.0, speed + kStep * acceleration(way, speed));
    way += kStep * speed;
  }
  return way;
}

}  // namespace weft
