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

/// The pair's own direction, and where both do not differ too much that which the node will have.
Outward mixed(const Outward& pairs_own, const Vec3d& direction, double way) {
  const double cosine = dot(direction, pairs_own.direction);
  const double part = std::clamp((cosine - kRoundCosine) / kRoundFade, 0.0, 1.0);
  const Vec3d sum = pairs_own.direction + part * (direction - pairs_own.direction);
  return {sum / length(sum), pairs_own.way + part * (way - pairs_own.way)};
}

/// A round obstacle presses a node away from its axis, in the direction that the node will have: equation (11b).
Outward turned(const Outward& pairs_own, const RoundAxis& axis, const Vec3d& place, const Vec3d& moved) {
  const double before = closest_on_segment(place, axis.start[0], axis.start[1]).distance;
  const ClosestOnSegment after = closest_on_segment(place + moved, axis.end[0], axis.end[1]);
  const Vec3d& arm = after.offset;
  const double size = after.distance;
  if (!(size > 0)) return pairs_own;
  return mixed(pairs_own, arm / size, size - before);
}

/// The same of a mesh, as the smooth surface that it stands for: equation (11c).
Outward turned(const Outward& pairs_own, const CurvedSurface& surface, double distance, const Vec3d& place,
               const Vec3d& moved, double dt) {
  if (surface.shape == Mat3{}) return pairs_own;
  const Vec3d& n = pairs_own.direction;
  // From where it touches to where the node is and will be, along the surface.
  const auto along = [&](const Vec3d& way) { return way - dot(n, way) * n; };
  const Vec3d before = along(place - surface.place),
              after = along(place - surface.place + moved - dt * surface.velocity);
  const Vec3d turn = surface.shape * after;
  const double size = dot(after, after), bent = dot(after, turn);
  const double less = size > 0 ? 1 / std::max(1 + distance * bent / size, kLeastSpread) : 1;
  const Vec3d direction = n + less * turn + dt * cross(surface.spin, n);
  return mixed(pairs_own, direction / length(direction),
               pairs_own.way + 0.5 * less * (bent - dot(before, surface.shape * before)));
}

}  // namespace

std::vector<Press> presses_of(std::span<const NearPair> pairs, std::span<const Vec3d> position,
                              std::span<const Vec3d> velocity, double dt, bool own_pairs) {
  std::vector<Press> presses(velocity.size());
  for (const NearPair& pair : pairs) {
    if (!pair.with_body || !pair.may || pair.untangles) continue;
    // Edges over a capsule press both their nodes, each along its own direction.
    if (pair.round && pair.node_count == 1 && pair.round->start[0] != pair.round->start[1]) continue;
    const double way = dt * dot(pair.direction, relative_velocity(pair, velocity));
    if (!(pair.distance + std::min(way, 0.0) < kContactTouching * pair.thickness)) continue;
    const double missing = pair.thickness - pair.distance, most = kMostLack * pair.thickness;
    const double room = std::min(missing, kHoldPart * missing);  // Hold bounds its speed
    for (std::uint32_t k = 0; k < pair.node_count; ++k) {
      const double weight = std::abs(pair.weights[k]);
      // A bound has no weight: what presses beside a node would hold it up as if it were under it.
      if (weight == 0 || (own_pairs && !pair.round && weight < kWholeWeight)) continue;
      const double side = pair.weights[k] > 0 ? 1 : -1;
      // A node's own way, not the pair's: neighbours that differ in speed would be made to go on differing.
      const std::uint32_t node = pair.nodes[k];
      Outward outward{side * pair.direction, dt * dot(pair.direction, side * velocity[node] + pair.surface)};
      const Vec3d moved = dt * velocity[node];
      if (pair.round) outward = turned(outward, *pair.round, position[node], moved);
      if (pair.curved) outward = turned(outward, *pair.curved, pair.distance, position[node], moved, dt);
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
