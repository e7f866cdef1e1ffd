#include "scene/screw.hpp"

#include <algorithm>
#include <cmath>

#include "base/quaternion.hpp"
#include "base/trig.hpp"
#include "scene/format.hpp"

namespace weft::scene {

RigidTransform transform_of(const Placement& placement) {
  const Mat3 r = matrix_of(placement.rotation);
  return {{r.x.x, r.x.y, r.x.z, r.y.x, r.y.y, r.y.z, r.z.x, r.z.y, r.z.z}, placement.position};
}

Result<Placement> checked_placement(const Placement& placement) {
  double sum = 0;  // of squares
  for (const double part : placement.rotation) sum += part * part;
  const Vec3d& p = placement.position;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || !std::isfinite(sum))
    return input_error("The placement at (%g, %g, %g), turned by (%g, %g, %g, %g), is not finite.", p.x, p.y,
                       p.z, placement.rotation[0], placement.rotation[1], placement.rotation[2],
                       placement.rotation[3]);
  const double size = std::sqrt(sum);
  if (!(std::abs(size - 1) <= kUnitTolerance))
    return input_error("The rotation has length %g; a unit quaternion's is within %g of 1.", size,
                       kUnitTolerance);
  Placement unit = placement;
  for (double& part : unit.rotation) part /= size;
  return unit;
}

/// The way takes x to Q x + d, with Q of the turn between the two and d = t₁ - Q t₀.
Screw::Screw(const Placement& from, const Placement& to) : from_(from), to_(to) {
  if (from.rotation == to.rotation) return;  // a straight way, as a path's
  Quaternion turn = product(to.rotation, conjugate(from.rotation));
  if (turn[3] < 0) turn = {-turn[0], -turn[1], -turn[2], -turn[3]};  // by half a turn at most
  const Vec3d sine{turn[0], turn[1], turn[2]};
  const double size = length(sine);
  if (!(size > 0)) return;
  axis_ = sine / size;
  half_ = angle_of({turn[3], size});
  const Vec3d shift = to.position - matrix_of(turn) * from.position;
  along_ = dot(axis_, shift) * axis_;
  across_ = shift - along_;
  side_ = cross(axis_, across_);
}

/// With α the part of the half angle β and c the point that the turn's axis goes through, d(s) = s d∥ + c - Q(s) c. It
/// is far off where β is small, so it is put in: c = (d⊥ + cot β a x d⊥) / 2 leaves
///     d(s) = s d∥ + sin α / sin β (cos(β - α) d⊥ - sin(β - α) a x d⊥),
/// in which nothing cancels.
Placement Screw::at(double part) const {
  if (part <= 0) return from_;
  if (part >= 1) return to_;
  if (half_ == 0) return {from_.position * (1 - part) + to_.position * part, from_.rotation};
  const Turn now = turn_of(part * half_), left = turn_of(half_ - part * half_), whole = turn_of(half_);
  const Quaternion turn{now.sine * axis_.x, now.sine * axis_.y, now.sine * axis_.z, now.cosine};
  const Vec3d shift = part * along_ + now.sine / whole.sine * (left.cosine * across_ - left.sine * side_);
  return {matrix_of(turn) * from_.position + shift, product(turn, from_.rotation)};
}

/// The derivative by s at 0: 2 β a x p + d∥ + β / sin β (cos β d⊥ - sin β a x d⊥).
double Screw::length_of(const Vec3d& point) const {
  if (half_ == 0) return length(to_.position - from_.position);
  const Turn whole = turn_of(half_);
  return length(2 * half_ * cross(axis_, point) + along_ +
                half_ / whole.sine * (whole.cosine * across_ - whole.sine * side_));
}

/// A time that is a way's begin but for rounding is of the way before it, so that a frame ends in the same place
/// whether the next way is known or not.
Placement placement_at(const MotionCarried& motion, double time) {
  constexpr double kSlack = 1e-6;  // of a way's time
  const auto next = std::find_if(motion.ways.begin(), motion.ways.end(), [&](const CarriedWay& way) {
    return !(time > way.begin + kSlack * (way.end - way.begin));
  });
  if (motion.ways.empty()) return {};
  if (next == motion.ways.begin()) return next->from;
  const CarriedWay& way = *(next - 1);
  const double part = (time - way.begin) / (way.end - way.begin);
  return Screw(way.from, way.to).at(part < 1 - kSlack ? part : 1);
}

}  // namespace weft::scene
