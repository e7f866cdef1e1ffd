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

/// Equation (3): the least normal velocity that the pair may end with, from the predicted one.
double least_speed(const NearPair& pair, double u_n, std::span<const double> inverse_mass,
                   const ContactLaw& law) {
  const double room = std::max(0.0, pair.distance - pair.thickness);
  const bool closing = -u_n > speed_of_load(law.dt, law.load);
  const bool bounces = law.restitution > 0 && closing && pair.distance + law.dt * u_n < pair.thickness;
  if (!bounces) return -room / law.dt;
  double loaded = pair.rigid ? pair.rigid->weight : 0;  // a body falls as cloth does
  for (std::uint32_t k = 0; k < pair.node_count; ++k)
    if (inverse_mass[pair.nodes[k]] > 0) loaded += pair.weights[k];
  const double toward = -loaded * law.dt * dot(pair.direction, law.load);
  return std::max(-room / law.dt, law.restitution * (-u_n - toward) - toward);
}

/// Equation (4), with W > 0: the impulse J of the pair, from the one that it had.
Vec3d impulse(const NearPair& pair, const Vec3d& had, const Vec3d& u, double least, double mobility) {
  const Vec3d& n = pair.direction;
  const double u_n = dot(n, u), had_n = dot(n, had);
  const double normal = std::max(0.0, had_n + (least - u_n) / mobility);
  const Vec3d sticking = (had - had_n * n) - (u - u_n * n) / mobility;
  return normal * n + no_longer(sticking, pair.friction * normal);
}

/// The same with a rigid body, whose inverse mass differs by the direction: along n first, then, from what is left,
/// across it. Each lessens the energy, as a part of the exact solution. docs/rigid.md, equation (5).
Vec3d impulse(const NearPair& pair, const Vec3d& had, const Vec3d& u, double least, const Mat3& mobility) {
  const Vec3d& n = pair.direction;
  const double had_n = dot(n, had);
  const double normal = std::max(0.0, had_n + (least - dot(n, u)) / dot(n, mobility * n));
  const Vec3d then = u + (normal - had_n) * (mobility * n);
  const Vec3d sticking = (had - had_n * n) - (then - dot(n, then) * n) / most_along(mobility, n);
  return normal * n + no_longer(sticking, pair.friction * normal);
}

/// Equation (4a): how much further an impulse goes that has changed so.
Vec3d ahead(const NearPair& pair, const Vec3d& change, const ContactLaw& law) {
  if (law.impulses.heavy) return kHeavyAhead * change;
  return kImpulseAhead * dot(pair.direction, change) * pair.direction;
}

/// Its part that the cone of friction about n allows.
Vec3d within_cone(const NearPair& pair, const Vec3d& impulse) {
  const double normal = std::max(0.0, dot(pair.direction, impulse));
  const Vec3d along = impulse - dot(pair.direction, impulse) * pair.direction;
  return normal * pair.direction + no_longer(along, pair.friction * normal);
}

/// Equation (3a): the impulse that the pair begins with: that of the substep before, less what takes back its parting.
Vec3d first_impulse(const NearPair& pair, double u_n, std::span<const double> inverse_mass,
                    const ContactLaw& law, double of_body) {
  double mobility = of_body;  // were the pair alone
  for (std::uint32_t k = 0; k < pair.node_count; ++k)
    mobility += pair.weights[k] * pair.weights[k] * inverse_mass[pair.nodes[k]];
  const double parting = u_n - speed_of_load(law.dt, law.load);
  return within_cone(pair, law.dt * pair.kept - (std::max(0.0, parting) / mobility) * pair.direction);
}

/// Equation (5a): how much further apart, of what is too near.
double push_of(const NearPair& pair, bool left, const ContactLaw& law) {
  const double spared = left ? kHeldLack * pair.thickness : 0;
  const double lack = std::clamp(pair.thickness - spared - pair.distance, 0.0, pair.thickness);
  const double part = kPushPart * std::min(1.0, lack / (kSoftLack * pair.thickness));
  const double longest = pair.of_bodies ? law.push_times.of_bodies : law.push_times.of_one_cloth;
  const double time = pair.of_one_system ? std::min(law.dt, longest) : law.dt;
  return std::min(part * lack, kPushSpeed * time);
}

/// Whether many of the cloth's acting pairs with cloth are nearer than the thickness that they keep.
bool is_pressed(std::span<const NearPair> pairs, const std::vector<bool>& acts) {
  std::int64_t pressed = 0, all = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!acts[p] || pairs[p].with_body || pairs[p].untangles) continue;
    ++all;
    if (pairs[p].distance < kPressedGap * pairs[p].thickness) ++pressed;
  }
  return kPressedOften * pressed > all;
}

}  // namespace

Vec3d relative_velocity(const NearPair& pair, std::span<const Vec3d> velocity) {
  Vec3d sum = pair.surface;
  for (std::uint32_t k = 0; k < pair.node_count; ++k) sum += pair.weights[k] * velocity[pair.nodes[k]];
  return sum;
}

Response respond(std::span<const NearPair> pairs, std::span<const Vec3d> velocity,
                 std::span<const double> inverse_mass, const ContactLaw& law,
                 std::span<const Movable> bodies) {
  Response response;
  response.body_impulses.assign(bodies.size(), {});
  response.body_pushes.assign(bodies.size(), {});
  std::vector<double> body_acting(bodies.size(), 0);
  response.change.assign(velocity.size(), {});
  response.push.assign(velocity.size(), {});
  response.acting.assign(velocity.size(), 0);
  response.impulses.assign(pairs.size(), {});
  response.acts.assign(pairs.size(), false);
  response.beside_cloth.assign(velocity.size(), false);
  response.struck.assign(velocity.size(), false);
  std::vector<std::uint32_t> urgency(pairs.size(), 0);
  std::vector<double> least(pairs.size(), 0),
      first_speed(pairs.size(), 0);             // w and u_n of the predicted velocities
  std::vector<bool> left(pairs.size(), false);  // pairs that are left to the solver
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const NearPair& pair = pairs[p];
    if (!pair.may) continue;
    const double u_n = dot(pair.direction, relative_velocity(pair, velocity));
    response.acts[p] =
        pair.solved || pair.distance + std::min(law.dt * u_n, 0.0) < kContactTouching * pair.thickness;
    if (!response.acts[p]) continue;
    first_speed[p] = u_n;
    least[p] = least_speed(pair, u_n, inverse_mass, law);
    urgency[p] = contact_urgency(pair.distance + std::min(law.dt * u_n, 0.0), pair.thickness);
    for (std::uint32_t k = 0; k < pair.node_count; ++k)
      response.acting[pair.nodes[k]] += urgency[p] * std::abs(pair.weights[k]);
    if (pair.rigid) body_acting[pair.rigid->collider] += urgency[p];
    const bool strikes = pair.with_body && pair.distance + law.dt * u_n < kStruckNear * pair.thickness;
    for (std::uint32_t k = 0; k < pair.node_count; ++k) {
      if (pair.weights[k] == 0) continue;
      if (!pair.with_body && (!pair.of_one_system || pair.untangles))
        response.beside_cloth[pair.nodes[k]] = true;
      if (strikes) response.struck[pair.nodes[k]] = true;
    }
  }
  std::vector<Vec3d> now(velocity.begin(), velocity.end());
  const auto give = [&](std::vector<Vec3d>& nodes, const NearPair& pair, const Vec3d& amount) {
    for (std::uint32_t k = 0; k < pair.node_count; ++k)
      nodes[pair.nodes[k]] += (pair.weights[k] * inverse_mass[pair.nodes[k]]) * amount;
  };
  const auto give_body = [](std::vector<RigidImpulse>& all, const NearPair& pair, const Vec3d& amount) {
    if (!pair.rigid) return;
    RigidImpulse& sum = all[pair.rigid->collider];
    sum.linear += pair.rigid->weight * amount;
    sum.angular += pair.rigid->weight * cross(pair.rigid->arm, amount);
  };
  /// What impulses so far have changed of the body's velocity at the pair's place, with the pair's sign.
  const auto body_change = [&](const NearPair& pair, const std::vector<RigidImpulse>& given) {
    if (!pair.rigid) return Vec3d{};
    const Movable& body = bodies[pair.rigid->collider];
    const RigidImpulse& sum = given[pair.rigid->collider];
    return pair.rigid->weight *
           (body.inverse_mass * sum.linear + cross(body.inverse_inertia * sum.angular, pair.rigid->arm));
  };
  std::vector<Mat3> whole(pairs.size());  // equation (5) of docs/rigid.md
  std::vector<OutOfBody> out_of_bodies(velocity.size());
  std::vector<double> mobility(pairs.size(), 0);  // equation (2); 0: it is not answered here
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!response.acts[p]) continue;
    const NearPair& pair = pairs[p];
    if (pair.untangles && pair.with_body) {
      for (std::uint32_t k = 0; k < pair.node_count; ++k)
        out_of_bodies[pair.nodes[k]].add(pair, pair.weights[k]);
      continue;
    }
    for (std::uint32_t k = 0; k < pair.node_count; ++k)
      mobility[p] += std::abs(pair.weights[k]) * response.acting[pair.nodes[k]] * inverse_mass[pair.nodes[k]];
    mobility[p] /= urgency[p];
    double of_body = 0;
    if (pair.rigid) {
      const Mat3 own = bodies[pair.rigid->collider].mobility(pair.rigid->arm);
      of_body = dot(pair.direction, own * pair.direction);
      whole[p] = Mat3::identity(mobility[p]) + (body_acting[pair.rigid->collider] / urgency[p]) * own;
      mobility[p] = dot(pair.direction, whole[p] * pair.direction);
    }
    if (!(mobility[p] > 0)) continue;
    left[p] = pair.held && std::none_of(pair.nodes.begin(), pair.nodes.begin() + pair.node_count,
                                        [&](std::uint32_t node) { return response.beside_cloth[node]; });
    if (pair.solved) {
      response.impulses[p] = law.dt * pair.kept;
      continue;
    }
    if (!pair.untangles)
      response.impulses[p] = first_impulse(pair, first_speed[p], inverse_mass, law, of_body);
    give(now, pair, response.impulses[p]);
    give_body(response.body_impulses, pair, response.impulses[p]);
  }
  const std::uint32_t iterations =
      is_pressed(pairs, response.acts) ? law.impulses.pressed : law.impulses.iterations;
  std::vector<Vec3d> begun = response.impulses;  // what the last iteration ended with, before it went ahead
  for (std::uint32_t iteration = 0; iteration < iterations; ++iteration) {
    const std::vector<Vec3d> before = now;
    const std::vector<RigidImpulse> given = response.body_impulses;
    const bool goes_ahead = iteration + 1 < iterations;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (!(mobility[p] > 0)) continue;
      const NearPair& pair = pairs[p];
      const Vec3d u = relative_velocity(pair, before) + body_change(pair, given), had = response.impulses[p];
      const Vec3d wanted = pair.untangles ? had + push_apart(pair, u, mobility[p], law)
                           : pair.solved  ? had
                           : left[p]      ? Vec3d{}
                           : pair.rigid   ? impulse(pair, had, u, least[p], whole[p])
                                          : impulse(pair, had, u, least[p], mobility[p]);
      response.impulses[p] = wanted;
      if (goes_ahead && !pair.untangles && !pair.solved && !left[p])
        response.impulses[p] += ahead(pair, wanted - begun[p], law);
      begun[p] = wanted;
      give(now, pair, response.impulses[p] - had);
      give_body(response.body_impulses, pair, response.impulses[p] - had);
    }
  }
  for (std::size_t p = 0; p < pairs.size(); ++p)
    if (mobility[p] > 0 && !pairs[p].untangles) {
      const Vec3d apart =
          (push_of(pairs[p], left[p] || pairs[p].solved, law) / mobility[p]) * pairs[p].direction;
      give(response.push, pairs[p], apart);
      give_body(response.body_pushes, pairs[p], apart);
    }
  for (std::size_t node = 0; node < velocity.size(); ++node) {
    now[node] += out_of_bodies[node].change(now[node], law.dt);
    response.change[node] = now[node] - velocity[node];
  }
  return response;
}

}  // namespace weft::reference
