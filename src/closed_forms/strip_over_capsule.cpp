#include "closed_forms/strip_over_capsule.hpp"

#include <algorithm>
#include <cmath>

namespace weft {
namespace {

/// The part of friction by which the rope rests, if that holds it.
RopeOverCapsule at_rest(RopeOverCapsule rope) {
  double least = -rope.friction, most = rope.friction;
  for (int k = 0; k < 50; ++k) {
    rope.friction = 0.5 * (least + most);
    (rope.acceleration(0, 0) > 0 ? least : most) = rope.friction;
  }
  return rope;
}

}  // namespace

StripOverCapsule::StripOverCapsule(const RopeOverCapsule& about, std::uint32_t touching, double compliance)
    : rope_(about),
      turn_(std::acos(-1.0) / touching),
      edge_(2 * about.radius * std::tan(0.5 * turn_)),
      touching_(touching) {
  const auto left = static_cast<std::uint32_t>(about.left / edge_) + 1,
             right = static_cast<std::uint32_t>(about.right / edge_) + 1;
  rope_.left = (left - 0.5) * edge_;
  rope_.right = (right - 0.5) * edge_;
  const double begun = std::max(0.0, rope_.acceleration(0, 0));
  const RopeOverCapsule rope = begun > 0 ? rope_ : at_rest(rope_);

  std::vector<double> stretch;  // of each edge, 1
  for (std::uint32_t k = 0; k < left; ++k)
    stretch.push_back(1 + compliance * (rope.gravity + begun) * (k + 0.5) * edge_);
  double on_rail = 0.5 * stretch.back();
  for (std::uint32_t k = 1; k < touching; ++k) {
    stretch.push_back(1 + compliance * rope.tension(k * turn_, begun));
    on_rail += stretch.back();
  }
  for (std::uint32_t k = right; k-- > 0;)
    stretch.push_back(1 + compliance * (rope.gravity - begun) * (k + 0.5) * edge_);
  on_rail += 0.5 * stretch[left + touching - 1];
  cell_ = touching * edge_ / on_rail;

  along_.push_back(0);
  for (const double one : stretch) along_.push_back(along_.back() + cell_ * one);
  const double first = 0.5 * (along_[left - 1] + along_[left]);
  for (double& along : along_) along -= first;
}

double StripOverCapsule::friction_of_chain() const {
  return 2 / turn_ * std::atanh(rope_.friction * std::tan(0.5 * turn_));
}

Vec3d StripOverCapsule::draped(const Vec3d& flat) const {
  const double along = along_[static_cast<std::size_t>(std::lround(flat.x / cell_ + 0.5 * (rows() - 1)))];
  const double arc = touching_ * edge_;
  if (along < 0) return {-rope_.radius, along, flat.z};
  if (along > arc) return {rope_.radius, arc - along, flat.z};
  const double angle = along / edge_ * turn_, out = rope_.radius / std::cos(0.5 * turn_);
  return {-out * std::cos(angle), out * std::sin(angle), flat.z};
}

}  // namespace weft
