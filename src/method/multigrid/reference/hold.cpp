#include "method/multigrid/reference/hold.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rules/contact_law.hpp"

namespace weft::reference {
std::optional<Hold> Hold::of(const Press& press, const HoldForce& kept, const HoldInputs& node) {
  const double size = length(press.normal);
  if (press.weight == 0 || size < kAgree * press.weight) return {};
  Hold hold;
  hold.node_ = node;
  hold.normal_ = press.normal / size;
  const bool bears = kept.normal > 0;
  const double gap = press.restored / press.weight;
  const double part = bears ? std::min(1.0, kHoldRate * node.dt / kHoldPart) : 1.0;
  hold.restored_ = std::min(part * gap, kHoldSpeed * node.dt);
  hold.lack_ = press.lack / press.weight - (gap - hold.restored_);
  // What bears has its load in the force that it bore: its residual reads its neighbours' speeds.
  const double load = bears ? kept.normal : -dot(node.load, hold.normal_);
  if (!(node.inertia * hold.lack_ + load > 0)) return {};
  const Vec3d turned = part_across(kept.along, hold.normal_);  // with the obstacle's surface
  hold.kept_ = {kept.normal, length(turned) > 0 ? length(kept.along) / length(turned) * turned : Vec3d{},
                kept.under_cloth};
  const double inertia = std::min(press.weight, 1.0) * node.inertia;
  hold.stiffness_ = kHoldStiffness * inertia;
  if (node.behind)
    hold.stiffness_ *= std::sqrt(dot(hold.normal_, *node.behind * hold.normal_) / node.inertia);
  hold.slip_stiffness_ = kSlipStiffness * inertia;
  hold.friction_ = press.friction / press.weight;
  hold.surface_way_ = node.dt / press.weight * press.surface;
  hold.alike_ = size >= kAlike * press.weight && bears;
  hold.sticks_ = length(hold.reach(node.start)) <= hold.friction_ * kept.normal;
  return hold;
}

Vec3d Hold::reach(const Vec3d& way) const {
  return kept_.along - slip_stiffness_ * part_across(way - surface_way_, normal_);
}

Vec3d Hold::force() const {
  const Vec3d tried = reach(node_.start);
  return (kept_.normal + stiffness_ * lack_) * normal_ +
         (sticks_ ? tried : no_longer(tried, friction_ * kept_.normal));
}

Sym3 Hold::block() const {
  const Sym3 normal = Sym3::outer(normal_, stiffness_);
  if (!sticks_) return normal;
  return normal + slip_stiffness_ * (Sym3::identity(1) + Sym3::outer(normal_, -1));
}

Hold::End Hold::end(const Vec3d& unknown) const {
  const Vec3d way = node_.start + unknown, reached = reach(way);
  const double pressed = kept_.normal + stiffness_ * (lack_ - dot(normal_, unknown));
  const double borne = std::max(0.0, pressed - node_.inertia * restored_);
  const Vec3d along = no_longer(reached, friction_ * borne);
  const Vec3d had = sticks_ ? reached : no_longer(reach(node_.start), friction_ * kept_.normal);
  // What acted beyond what counts is taken out of the velocity, and so is the speed at which a gap is restored.
  const Vec3d more = along - had + std::max(0.0, -pressed) * normal_;
  // No more than a node that slips has to gain, its own speed over the surface: springs that let go would give it far
  // more than it can take.
  const Vec3d moved = way - surface_way_ - restored_ * normal_;
  const Vec3d freed = no_longer(node_.dt / node_.mass * more, kMostFreed / node_.dt * length(moved));
  // Under cloth no force was kept: friction has not acted yet, and stops the way as well.
  const Vec3d stopped = kept_.under_cloth ? node_.dt * part_across(freed, normal_) : Vec3d{};
  // What stops a node that nothing else holds, beyond what it has borne: a blow, and it is over.
  const double alone = stiffness_ * node_.inertia / (stiffness_ + node_.inertia);
  const double blow = alone * std::max(0.0, lack_ + dot(normal_, node_.start - node_.ahead));
  const double kept = std::max(kLanded * borne, borne - std::max(0.0, blow - kept_.normal));
  return {{kept, no_longer(along, friction_ * kept)},
          way / node_.dt - restored_ / node_.dt * normal_ + freed,
          stopped};
}

}  // namespace weft::reference
