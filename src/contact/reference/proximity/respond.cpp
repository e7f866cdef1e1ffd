#include "contact/reference/proximity/respond.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

double untangling_speed(double thickness, double dt) {
  return thickness * std::min(kUntanglePart / dt, kUntangleRate);
}

/// Equation (7), with W > 0: no spring, no friction.
Vec3d push_apart(const NearPair& pair, const Vec3d& u, double mobility, const ContactLaw& law) {
  const double speed = -pair.distance * untangling_speed(pair.thickness, law.dt);
  return (std::max(0.0, speed - dot(pair.direction, u)) / mobility) * pair.direction;
}

/// Equation (7d): the demand on a node of its pairs with bodies that contain it.
class OutOfBody {
 public:
  void add(const NearPair& pair, double weight) {
    const double part = -pair.distance * weight;
    way_ += part * pair.direction;
    surface_ -= part * pair.surface;
    parts_ += std::abs(part);
    thickness_ = pair.thickness;
  }
  Vec3d change(const Vec3d& velocity, double dt) const {
    if (!(parts_ > 0) || !(length(way_) > 0)) return {};
    const Vec3d n = way_ / length(way_);
    return std::max(0.0, untangling_speed(thickness_, dt) - dot(n, velocity - surface_ / parts_)) * n;
  }

 private:
  Vec3d way_, surface_;
  double parts_ = 0, thickness_ = 0;
};

/// Equations (3) and (4), with W > 0.
Vec3d impulse(const NearPair& pair, const Vec3d& u, double mobility, const ContactLaw& law) {
  const double h = pair.thickness, d = pair.distance, u_n = dot(pair.direction, u);
  double normal = std::max(0.0, (std::min(kContactWall * h - d, 0.0) / law.dt - u_n) / mobility);
  const double spring = d < kContactTouching * h
                            ? kContactSpring * std::clamp(h - d, 0.0, h) / law.dt - law.damping * u_n
                            : law.damping * ((h - d) / law.dt - u_n);
  normal = std::max(normal, spring / mobility);
  const Vec3d sliding = u - u_n * pair.direction;
  const double slip = length(sliding);
  Vec3d total = normal * pair.direction;
  if (slip > 0) total -= (std::min(pair.friction * normal, slip / mobility) / slip) * sliding;
  return total;
}

}  // namespace

Vec3d relative_velocity(const NearPair& pair, std::span<const Vec3d> velocity) {
  Vec3d sum = pair.surface;
  for (std::uint32_t k = 0; k < pair.node_count; ++k) sum += pair.weights[k] * velocity[pair.nodes[k]];
  return sum;
}

Response respond(std::span<const NearPair> pairs, std::span<const Vec3d> velocity,
                 std::span<const double> inverse_mass, const ContactLaw& law) {
  Response response;
  response.change.assign(velocity.size(), {});
  response.acting.assign(velocity.size(), 0);
  response.impulses.assign(pairs.size(), {});
  response.acts.assign(pairs.size(), false);
  std::vector<std::uint32_t> urgency(pairs.size(), 0);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const NearPair& pair = pairs[p];
    if (!pair.may) continue;
    const double u_n = dot(pair.direction, relative_velocity(pair, velocity));
    response.acts[p] = pair.distance + std::min(law.dt * u_n, 0.0) < kContactTouching * pair.thickness;
    if (!response.acts[p]) continue;
    urgency[p] = contact_urgency(pair.distance + std::min(law.dt * u_n, 0.0), pair.thickness);
    for (std::uint32_t k = 0; k < pair.node_count; ++k)
      if (pair.weights[k] != 0) response.acting[pair.nodes[k]] += urgency[p];
  }
  std::vector<OutOfBody> bodies(velocity.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!response.acts[p]) continue;
    const NearPair& pair = pairs[p];
    if (pair.untangles && pair.with_body) {
      for (std::uint32_t k = 0; k < pair.node_count; ++k) bodies[pair.nodes[k]].add(pair, pair.weights[k]);
      continue;
    }
    double mobility = 0;  // equation (2)
    for (std::uint32_t k = 0; k < pair.node_count; ++k)
      mobility +=
          pair.weights[k] * pair.weights[k] * response.acting[pair.nodes[k]] * inverse_mass[pair.nodes[k]];
    mobility /= urgency[p];
    if (!(mobility > 0)) continue;
    const Vec3d u = relative_velocity(pair, velocity);
    response.impulses[p] =
        pair.untangles ? push_apart(pair, u, mobility, law) : impulse(pair, u, mobility, law);
    for (std::uint32_t k = 0; k < pair.node_count; ++k)
      response.change[pair.nodes[k]] +=
          (pair.weights[k] * inverse_mass[pair.nodes[k]]) * response.impulses[p];
  }
  for (std::size_t node = 0; node < velocity.size(); ++node)
    response.change[node] += bodies[node].change(velocity[node] + response.change[node], law.dt);
  return response;
}

}  // namespace weft::reference
