// Where a motion has taken its nodes. No libm but the root: the same bits on every machine.
#pragma once

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// p' = rotation p + translation.
struct RigidTransform {
  double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // row by row
  Vec3d translation;                                 // [m]

  Vec3d operator()(const Vec3d& p) const {
    return Vec3d{rotation[0] * p.x + rotation[1] * p.y + rotation[2] * p.z,
                 rotation[3] * p.x + rotation[4] * p.y + rotation[5] * p.z,
                 rotation[6] * p.x + rotation[7] * p.y + rotation[8] * p.z} +
           translation;
  }
};

/// The transform from a rest position in the world to its place at `time` [s]. Of a collider, the place that the
/// scene gives is the rest position.
RigidTransform motion_at(const MotionShape& shape, double time);
RigidTransform motion_at(const Motion& motion, double time);

/// The angular velocity of what turns by a small angle from one place to the other in `step` s [rad/s].
Vec3d spin_between(const RigidTransform& from, const RigidTransform& to, double step);

/// How far a motion has come `elapsed` s after its start: the speed rises linearly from 0 in `ramp` s, stays,
/// and falls in `ramp` s to 0 at `end`. Where `end` is too near for the full speed, both ramps are cut short
/// with the same slope.
double travelled(double elapsed, double speed, double ramp, const std::optional<double>& end);

}  // namespace weft::scene
