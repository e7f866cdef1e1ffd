#include "method/holds/reference/node_hold.hpp"

#include <algorithm>

#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

/// The part of a node's compliance along the normal that friction of what slides leaves of it, at least.
constexpr double kLeastCompliance = 0.25;

}  // namespace

std::optional<NodeHold> NodeHold::of(const Press& press, const Vec3d& ahead, double dt) {
  const double size = length(press.normal);
  if (press.weight == 0 || size < kAgree * press.weight) return {};
  NodeHold hold;
  hold.normal_ = press.normal / size;
  const double gap = press.restored / press.weight;
  hold.restored_ = std::min(std::min(1.0, kHoldRate * dt / kHoldPart) * gap, kHoldSpeed * dt);
  hold.least_ = dot(hold.normal_, ahead) + press.lack / press.weight - (gap - hold.restored_);
  hold.surface_way_ = dt / press.weight * press.surface;
  hold.friction_ = press.friction / size;  // of what all pairs bear, not of their sum
  hold.alike_ = size >= kAlike * press.weight;
  return hold;
}

Vec3d NodeHold::descend(const NodeDescent& node) {
  const double lack = least_ - dot(normal_, node.free);
  bears_ = lack > 0;
  if (!bears_) return node.free;
  const auto across = [&](const Vec3d& v) { return v - dot(normal_, v) * normal_; };
  const Vec3d stuck = across(surface_way_) + least_ * normal_;
  const Vec3d needed = node.hessian * (stuck - node.free);  // the force, by the node's inertia [m]
  const double normal = dot(normal_, needed);
  const Vec3d along = across(needed);
  if (length(along) <= friction_ * normal) return stuck;
  const Sym3 compliance = inverse(node.hessian);
  const double plain = dot(normal_, compliance * normal_);
  const Vec3d pull = length(along) > 0 ? normal_ + friction_ / length(along) * along : normal_;
  const double soft = std::max(dot(normal_, compliance * pull), kLeastCompliance * plain);
  return node.free + lack / soft * (compliance * pull);
}

Vec3d NodeHold::project(const Vec3d& way) {
  const auto across = [&](const Vec3d& v) { return v - dot(normal_, v) * normal_; };
  const double normal = std::max(0.0, dot(normal_, held_) + least_ - dot(normal_, way));
  const Vec3d tried = across(held_ - (way - surface_way_));
  const double most = friction_ * normal, size = length(tried);
  const Vec3d before = held_;
  held_ = normal * normal_ + (size > most ? most / size : 1) * tried;
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
      holds_[node] = NodeHold::of(presses[node], substep.dt * velocity[node], substep.dt);
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
    if (holds_[node]) substep.system.velocity[node] = holds_[node]->moved(ways[node]) / substep.dt;
}

}  // namespace weft::reference
