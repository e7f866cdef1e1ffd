#include "contact/rules/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

/// -ln x for x in (0, 1]: x = m / 2^k with m in (1/2, 1], and ln m = 2 artanh((m - 1) / (m + 1)).
double minus_log(double x) {
  constexpr double kLog2 = 0.6931471805599453;
  double halvings = 0;
  for (; x <= 0.5; x *= 2) ++halvings;
  const double z = (1 - x) / (1 + x),
               square = z * z;  // z < 1/3: the first term that is dropped is below 1e-18
  double sum = 0;
  for (int k = 35; k >= 1; k -= 2) sum = sum * square + 1.0 / k;
  return halvings * kLog2 + 2 * z * sum;
}

}  // namespace

std::uint32_t contact_urgency(double gap, double thickness) {
  const double depth = std::clamp(1 - gap / thickness, 0.0, 1.0);
  return 1 + static_cast<std::uint32_t>(255 * depth * depth);
}

double contact_damping(double restitution) {
  constexpr double kPi = 3.141592653589793;
  double ratio = 1;
  if (restitution > 0) {
    const double log = minus_log(restitution);
    ratio = log / std::sqrt(kPi * kPi + log * log);
  }
  return 2 * ratio * std::sqrt(kContactSpring);
}

double shortest_altitude(const Model& model) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const mesh::Triangle& t : model.triangles) {
    const Vec3d &a = model.rest_position[t[0]], &b = model.rest_position[t[1]],
                &c = model.rest_position[t[2]];
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    shortest = std::min(shortest, length(cross(b - a, c - a)) / longest);
  }
  return shortest;
}

double self_thickness(const Model& model, double thickness) {
  return std::min(thickness, 0.5 * shortest_altitude(model));
}

double flat_reach(const Model& model, const scene::Contact& contact) {
  const double altitude = shortest_altitude(model);
  if (!contact.self) return 0.5 * altitude;
  return 0.5 *
         (0.95 * altitude - self_thickness(model, contact.thickness));  // h_s + 2b is below the altitude
}

}  // namespace weft
