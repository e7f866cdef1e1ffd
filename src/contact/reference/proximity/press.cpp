#include "contact/reference/proximity/press.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rules/contact_law.hpp"

namespace weft::reference {

std::vector<Press> presses_of(std::span<const NearPair> pairs, std::span<const Vec3d> velocity, double dt) {
  std::vector<Press> presses(velocity.size());
  for (const NearPair& pair : pairs) {
    if (!pair.with_body || !pair.may || pair.untangles) continue;
    const double way = dt * dot(pair.direction, relative_velocity(pair, velocity));
    if (!(pair.distance + std::min(way, 0.0) < kContactTouching * pair.thickness)) continue;
    const double missing = pair.thickness - pair.distance, most = kMostLack * pair.thickness;
    const double room = std::min(missing, kHoldPart * missing);  // Hold bounds its speed
    for (std::uint32_t k = 0; k < pair.node_count; ++k) {
      const double weight = std::abs(pair.weights[k]);
      if (weight == 0) continue;
      const double side = pair.weights[k] > 0 ? 1 : -1;
      // A node's own way, not the pair's: neighbours that differ in speed would be made to go on differing.
      const double own_way = dt * dot(pair.direction, side * velocity[pair.nodes[k]] + pair.surface);
      const double lack = std::clamp(room - own_way, -most, most);
      Press& press = presses[pair.nodes[k]];
      press.normal += weight * side * pair.direction;
      press.lack += weight * lack;
      press.restored += weight * std::max(room, 0.0);
      press.weight += weight;
      press.surface -= weight * side * pair.surface;
      press.friction += weight * pair.friction;
    }
  }
  return presses;
}

}  // namespace weft::reference
