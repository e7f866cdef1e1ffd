#include "method/holds/reference/node_hold.hpp"

#include <algorithm>

#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

/// The part of a node's compliance along the normal that friction of what slides leaves of it, at least.
constexpr double kLeastCompliance = 0.25;

}  // namespace

std::optional<NodeHold> NodeHold::of(const Press& press, const Vec3d& velocity, const Substep& substep) {
  const double dt = substep.dt;
  const double size = length(press.normal);
  if (press.weight == 0 || size < kAgree * press.weight) return {};
  NodeHold hold;
  hold.normal_ = press.normal / size;
  const double gap = press.restored / press.weight;
  hold.restored_ = std::min(std::min(1.0, kHoldRate * dt / kHoldPart) * gap, kHoldSpeed * dt);
  hold.least_ = dt * dot(hold.normal_, velocity) + press.lack / press.weight - (gap - hold.restored_);
  hold.surface_way_ = dt / press.weight * press.surface;
  hold.friction_ = press.friction / size;  // of what all pairs bear, not of their sum
  hold.alike_ = size >= kAlike * press.weight;
  const double comes = -dot(hold.normal_, velocity - press.surface / press.weight);
  const Vec3d& load = substep.system.acceleration;
  if (substep.restitution > 0 && comes > speed_of_load(dt, load))
    hold.return_speed_ = std::max(0.0, substep.restitution * comes + dt * dot(hold.normal_, load));
  return hold;
}

Vec3d NodeHold::velocity(const Vec3d& way, double dt) const {
  if (!bears_) return way / dt;
  const Vec3d v = (way - restored_ * normal_) / dt, own = v - surface_way_ / dt;
  const double more = return_speed_ - dot(normal_, own);
  if (return_speed_ == 0 || more <= 0) return v;
  return v + more * normal_ - no_longer(part_across(own, normal_), friction_ * more);
}

Vec3d NodeHold::descend(const NodeDescent& node) {
  const double lack = least_ - dot(normal_, node.free);
  bears_ = lack > 0;
  if (!bears_) return node.free;
  const Vec3d stuck = part_across(surface_way_, normal_) + least_ * normal_;
  const Vec3d needed = node.hessian * (stuck - node.free);  // the force, by the node's inertia [m]
  const double normal = dot(normal_, needed);
  const Vec3d along = part_across(needed, normal_);
  if (length(along) <= friction_ * normal) return stuck;
  const Sym3 compliance = inverse(node.hessian);
  const double plain = dot(normal_, compliance * normal_);
  const Vec3d pull = length(along) > 0 ? normal_ + friction_ / length(along) * along : normal_;
  const double soft = std::max(dot(normal_, compliance * pull), kLeastCompliance * plain);
  return node.free + lack / soft * (compliance * pull);
}

Vec3d NodeHold::project(const Vec3d& way) {
  const double normal = std::max(0.0, dot(normal_, held_) + least_ - dot(normal_, way));
  const Vec3d tried = part_across(held_ - (way - surface_way_), normal_), before = held_;
  held_ = normal * normal_ + no_longer(tried, friction_ * normal);
  bears_ = normal > 0;
  return way + (held_ - before);
}

void NodeHolds::take(const Substep& substep) {
  const std::vector<Vec3d>& velocity = substep.system.velocity;
  holds_.assign(velocity.size(), {});
  answers_ = static_cast<bool>(substep.pressed);
  if (!answers_) return;
  const std::vector<Press> presses = substep.pressed(velocity).presses;
  for (std::size_t node = 0; node < holds_.size(); ++node)
    if (substep.system.inverse_mass[node] > 0)
      holds_[node] = NodeHold::of(presses[node], velocity[node], substep);
}

Ways NodeHolds::begin(const Substep& substep, LookBack& look_back, std::vector<Vec3d>& aim) {
  std::vector<bool> bore = held();
  bore.resize(substep.system.velocity.size());
  take(substep);
  const std::vector<Vec3d> velocity = substep.system.velocity, velocity_before = look_back.velocity_before();
  const std::vector<bool> known = look_back.known();
  Ways ways = look_back.begin(substep, aim);
  for (std::size_t node = 0; node < aim.size(); ++node) {
    if (!holds_[node] || ways.inverse_mass[node] == 0) continue;
    const Vec3d alone = holds_[node]->descend({aim[node], Sym3::identity(1)});
    if (!holds_[node]->bears()) continue;
    const Vec3d going_on = substep.dt * velocity[node], change = alone - going_on;
    const Vec3d felt = substep.dt * substep.ratio * (velocity[node] - velocity_before[node]);
    const bool is_pulled = bore[node] && known[node] && dot(felt, change) < 0;
    ways.way[node] = is_pulled ? going_on + no_longer(felt, length(change)) : alone;
  }
  return ways;
}

std::vector<bool> NodeHolds::held() const {
  if (!answers_) return {};
  std::vector<bool> held;
  for (const std::optional<NodeHold>& hold : holds_) held.push_back(hold && hold->bears() && hold->alike());
  return held;
}

void NodeHolds::end(const Substep& substep, const std::vector<Vec3d>& ways) const {
  for (std::size_t node = 0; node < holds_.size(); ++node)
    if (holds_[node]) substep.system.velocity[node] = holds_[node]->velocity(ways[node], substep.dt);
}

}  // namespace weft::reference
