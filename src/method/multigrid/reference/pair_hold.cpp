#include "method/multigrid/reference/pair_hold.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rules/contact_law.hpp"
#include "method/multigrid/reference/hold.hpp"

namespace weft::reference {

std::optional<PairHold> PairHold::of(const NearPair& pair, const Sides& sides, double dt) {
  PairHold hold;
  hold.near_ = pair;
  hold.sides_ = sides;
  const Vec3d& n = pair.direction;
  hold.kept_normal_ = std::max(0.0, dot(n, pair.kept));
  const bool bears = hold.kept_normal_ > 0;
  if (bears) hold.kept_along_ = no_longer(part_across(pair.kept, n), pair.friction * hold.kept_normal_);
  const double missing = pair.thickness - pair.distance, room = std::min(missing, kHoldPart * missing);
  const double gap = std::max(room, 0.0), part = bears ? std::min(1.0, kHoldRate * dt / kHoldPart) : 1.0;
  hold.restored_ = std::min(part * gap, kHoldSpeed * dt);
  const double wanted = room - (gap - hold.restored_);
  hold.lack_ = wanted - dot(n, sides.start);
  hold.blow_ = wanted - dot(n, sides.ahead);
  // What bears has its load in the force that it bore.
  const double closer = bears ? sides.compliance * hold.kept_normal_ : -dot(n, sides.pull);
  if (!(sides.compliance > 0) || !(hold.lack_ + closer > 0)) return {};
  const bool closes = pair.distance + dot(n, sides.start) < kCloses * std::min(pair.distance, pair.thickness);
  // The compliance of what hangs together lies between that of its masses and that with all neighbours fixed.
  const bool stiff = sides.local > 0 && closes;
  hold.stiffness_ = kPairStiffness / (stiff ? std::sqrt(sides.local * sides.compliance) : sides.compliance);
  if (sides.of_bodies > 0) hold.stiffness_ = kPairStiffness * sides.of_bodies;
  hold.slip_stiffness_ = kPairSlipStiffness / sides.compliance;
  hold.sticks_ = length(hold.reach(sides.start)) <= pair.friction * hold.kept_normal_;
  return hold;
}

Vec3d PairHold::applied() const {
  const Vec3d tried = reach(sides_.start);
  return sticks_ ? tried : no_longer(tried, near_.friction * kept_normal_);
}

void PairHold::add_force(Field& residual, const std::vector<bool>& fixed) const {
  const Vec3d force = (kept_normal_ + stiffness_ * lack_) * near_.direction + applied();
  for_each_node([&](std::uint32_t a, double weight) {
    if (!fixed[a]) residual[a] += weight * force;
  });
}

void PairHold::add_product(const Field& x, Field& product, const std::vector<bool>& fixed) const {
  Vec3d way;
  for_each_node([&](std::uint32_t a, double weight) {
    if (!fixed[a]) way += weight * x[a];
  });
  Vec3d force = stiffness_ * dot(near_.direction, way) * near_.direction;
  if (sticks_) force += slip_stiffness_ * part_across(way, near_.direction);
  for_each_node([&](std::uint32_t a, double weight) {
    if (!fixed[a]) product[a] += weight * force;
  });
}

PairHold::End PairHold::end(const Field& unknown, double dt) const {
  const Vec3d& n = near_.direction;
  Vec3d solution;
  for_each_node([&](std::uint32_t a, double weight) { solution += weight * unknown[a]; });
  const Vec3d way = sides_.start + solution, reached = reach(way);
  const double pressed = kept_normal_ + stiffness_ * (lack_ - dot(n, solution));
  const double borne = std::max(0.0, pressed - slip_stiffness_ * restored_);
  const Vec3d along = no_longer(reached, near_.friction * borne);
  const Vec3d more = along - (sticks_ ? reached : applied()) + std::max(0.0, -pressed) * n;
  // No more than the sides' own speed over each other; and not the speed at which a gap is restored.
  const Vec3d freed = no_longer(dt * sides_.mobility * more, kMostFreed / dt * length(way - restored_ * n));
  // What the spring stops alone of two sides that nothing else holds: a blow, and it is over.
  const double alone = stiffness_ / (1 + stiffness_ * sides_.compliance);
  const double kept = std::max(0.0, borne - alone * std::max(0.0, blow_));
  return {kept * n + no_longer(along, near_.friction * kept),
          (1 / sides_.mobility) * (freed - restored_ / dt * n)};
}

}  // namespace weft::reference
