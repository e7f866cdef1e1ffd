#include "contact/reference/proximity/press.hpp"

#include <algorithm>
#include <cmath>

#include "contact/reference/proximity/closest.hpp"
#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

/// How a node is pressed: in this direction, along which its way is so long.
struct Outward {
  Vec3d direction;
  double way = 0;  // over the obstacle [m]
};

/// A round obstacle presses a node away from its axis, in the direction that the node will have: equation (11b).
Outward turned(const Outward& pairs_own, const RoundAxis& axis, const Vec3d& place, const Vec3d& moved) {
  const double before = closest_on_segment(place, axis.start[0], axis.start[1]).distance;
  const ClosestOnSegment after = closest_on_segment(place + moved, axis.end[0], axis.end[1]);
  const Vec3d& arm = after.offset;
  const double size = after.distance;
  if (!(size > 0)) return pairs_own;
  const double cosine = dot(arm, pairs_own.direction) / size;
  const double part = std::clamp((cosine - kRoundCosine) / kRoundFade, 0.0, 1.0);
  const Vec3d direction = pairs_own.direction + part * (arm / size - pairs_own.direction);
  return {direction / length(direction), pairs_own.way + part * (size - before - pairs_own.way)};
}

}  // namespace

std::vector<Press> presses_of(std::span<const NearPair> pairs, std::span<const Vec3d> position,
                              std::span<const Vec3d> velocity, double dt) {
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
      const std::uint32_t node = pair.nodes[k];
      Outward outward{side * pair.direction, dt * dot(pair.direction, side * velocity[node] + pair.surface)};
      if (pair.round) outward = turned(outward, *pair.round, position[node], dt * velocity[node]);
      const double lack = std::clamp(room - outward.way, -most, most);
      Press& press = presses[node];
      press.normal += weight * outward.direction;
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
