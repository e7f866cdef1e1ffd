#include "scene/motion.hpp"

#include <algorithm>
#include <cmath>

#include "base/trig.hpp"
#include "scene/screw.hpp"

namespace weft::scene {
namespace {

RigidTransform shift(const Vec3d& offset) {
  RigidTransform transform;
  transform.translation = offset;
  return transform;
}

Vec3d path_offset(const MotionPath& path, double time) {
  const std::vector<PathPoint>& points = path.points;
  if (points.empty() || !(time > 0)) return points.empty() || points[0].time > 0 ? Vec3d{} : points[0].offset;
  if (path.loops && time >= points.back().time) time = std::fmod(time, points.back().time);
  const auto next = std::upper_bound(points.begin(), points.end(), time,
                                     [](double now, const PathPoint& p) { return now < p.time; });
  if (next == points.end()) return points.back().offset;
  const PathPoint from =
      next == points.begin() ? PathPoint{} : *(next - 1);  // at rest at time 0, unless given
  const double part = (time - from.time) / (next->time - from.time);
  return from.offset * (1 - part) + next->offset * part;
}

/// Rodrigues: R = cos I + sin [a]x + (1 - cos) a a^T about the unit axis a; p' = c + R (p - c).
RigidTransform rotation(const MotionRotation& motion, double angle) {
  const Turn turn = turn_of(angle);
  const Vec3d a = motion.axis;
  const double rest = 1 - turn.cosine;
  RigidTransform transform;
  const double skew[9] = {0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      transform.rotation[3 * row + column] =
          (row == column ? turn.cosine : 0) + turn.sine * skew[3 * row + column] + rest * a[row] * a[column];
  transform.translation = motion.center - transform(motion.center);
  return transform;
}

}  // namespace

double travelled(double elapsed, double speed, double ramp, const std::optional<double>& end) {
  if (!(elapsed > 0)) return 0;
  if (end && *end < speed * ramp) {  // speed^2 = 2 a (end / 2) at the middle, a = speed / ramp
    const double peak = std::sqrt(*end * speed / ramp);
    ramp *= peak / speed;
    speed = peak;
  }
  if (end) {
    const double left = *end / speed + ramp - elapsed;  // time until the end
    if (left <= 0) return *end;
    if (left < ramp) return *end - 0.5 * speed * left * (left / ramp);
  }
  if (elapsed < ramp) return 0.5 * speed * elapsed * (elapsed / ramp);
  return speed * (elapsed - 0.5 * ramp);
}

RigidTransform motion_at(const MotionShape& shape, double time) {
  if (const auto* line = std::get_if<MotionLine>(&shape))
    return shift(line->direction * travelled(time - line->start, line->speed, line->ramp, line->distance));
  if (const auto* path = std::get_if<MotionPath>(&shape)) return shift(path_offset(*path, time));
  if (const auto* given = std::get_if<MotionGiven>(&shape)) {
    if (!(time < given->end)) return shift(given->to);
    const double part = time > given->begin ? (time - given->begin) / (given->end - given->begin) : 0;
    return shift(given->from * (1 - part) + given->to * part);
  }
  if (const auto* moved = std::get_if<MotionCarried>(&shape)) return transform_of(placement_at(*moved, time));
  const auto& turn = *std::get_if<MotionRotation>(&shape);
  return rotation(turn, travelled(time - turn.start, turn.speed, turn.ramp, turn.angle));
}

RigidTransform motion_at(const Motion& motion, double time) { return motion_at(motion.shape, time); }

/// R₁ R₀ᵀ is the turn; its skew part over the time is the angular velocity.
Vec3d spin_between(const RigidTransform& from, const RigidTransform& to, double step) {
  double turn[9] = {};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      for (int k = 0; k < 3; ++k)
        turn[3 * row + column] += to.rotation[3 * row + k] * from.rotation[3 * column + k];
  return Vec3d{turn[7] - turn[5], turn[2] - turn[6], turn[3] - turn[1]} / (2 * step);
}

}  // namespace weft::scene
