// The way of a rigid thing from one place to another at constant velocity and constant spin: a part of a screw
// (Chasles). It depends on the two places alone, and not on a point that the thing would turn about: a way between two
// places of a line or of a rotation about any axis is that line or rotation. No libm but the root: the same bits on
// every machine.
#pragma once

#include "base/result.hpp"
#include "base/vec.hpp"
#include "scene/motion.hpp"
#include "weft/placement.hpp"

namespace weft::scene {

/// A turn by `angle` about `axis`, unit, through the origin, in the shorter sense, and a shift.
class Screw {
 public:
  Screw(const Placement& from, const Placement& to);

  /// After a part of the way, from 0 to 1; at both ends the very places.
  Placement at(double part) const;
  /// How far a point goes that is here at the way's start [m]: the same at any of its times.
  double length_of(const Vec3d& point) const;

 private:
  Placement from_, to_;
  Vec3d axis_{1, 0, 0};
  double half_ = 0;              // of the angle [rad]
  Vec3d along_, across_, side_;  // parts of the shift: along the axis, square to it, and axis x across [m]
};

RigidTransform transform_of(const Placement& placement);
/// With the rotation's length made 1. Errors  Input: a number is not finite; that length is not within kUnitTolerance
/// of 1.
Result<Placement> checked_placement(const Placement& placement);
/// Where a program's collider is at a time [s].
Placement placement_at(const MotionCarried& motion, double time);

}  // namespace weft::scene
