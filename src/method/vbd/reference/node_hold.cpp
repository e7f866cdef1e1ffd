#include "method/vbd/reference/node_hold.hpp"

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

}  // namespace weft::reference
