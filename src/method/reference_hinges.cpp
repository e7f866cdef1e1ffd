#include "method/reference_hinges.hpp"

#include <cmath>
#include <numbers>

namespace weft::reference {

hinge::Corners corners_of(const hinge::Hinge& hinge, const Ways& ways, std::uint32_t first) {
  hinge::Corners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = ways.place(first + hinge.nodes[i]);
  return corners;
}

Bend bend_of(const hinge::Hinge& hinge, const Ways& ways, std::uint32_t first, double delay, double dt) {
  const hinge::Corners corners = corners_of(hinge, ways, first);
  const hinge::Corners slope = hinge::angle_slope(corners);
  double turned = 0;
  for (std::size_t i = 0; i < 4; ++i) turned += dot(slope[i], ways.way[first + hinge.nodes[i]]);
  return {hinge::angle(corners) - hinge.rest_angle, delay / dt * turned};
}

double short_way(double difference) { return std::remainder(difference, 2 * std::numbers::pi); }

}  // namespace weft::reference
