#include "contact/rules/contact_steps.hpp"

#include <algorithm>
#include <cmath>

namespace weft {
namespace {

double from_axis(const scene::MotionRotation& turn, const Vec3d& point) {
  return length(cross(turn.axis, point - turn.center));
}

/// The speed of scene::travelled: it rises in `ramp`, stays, and falls in `ramp` to 0 at `end`, so in any
/// interval it is largest where that is nearest to the middle.
double profile_speed(double from, double to, double speed, double ramp, const std::optional<double>& end) {
  if (to < 0) return 0;
  double most = to;
  double left = ramp;  // time to the end of the motion, where it has one
  if (end) {
    if (*end < speed * ramp) {
      const double peak = std::sqrt(*end * speed / ramp);
      ramp *= peak / speed;
      speed = peak;
    }
    const double duration = speed > 0 ? *end / speed + ramp : 0;
    if (from > duration) return 0;
    most = std::clamp(duration / 2, std::max(from, 0.0), std::min(to, duration));
    left = duration - most;
  }
  const double part = ramp > 0 ? std::min({1.0, most / ramp, left / ramp}) : 1.0;
  return part * speed;
}

/// A stretch of time, beside pieces of a first round; what does not begin anew has no round.
struct Interval {
  Interval(double from, double to, std::optional<double> round_time)
      : begin(from), end(to), round(round_time) {
    if (!round) return;
    const double rounds = std::floor(begin / *round) * *round;
    begin -= rounds;
    end -= rounds;
  }
  /// Whether it meets a piece, in this round or in the next.
  bool meets(double from, double to) const {
    return (from <= end && to >= begin) || (round && from + *round <= end);
  }

  double begin, end;            // [s]
  std::optional<double> round;  // [s]
};

double path_speed(const scene::MotionPath& path, double begin, double end) {
  double most = 0;
  const Interval interval(begin, end, path.loops ? std::optional(path.points.back().time) : std::nullopt);
  scene::PathPoint from;  // at rest at time 0, unless given
  for (const scene::PathPoint& to : path.points) {
    if (to.time > from.time && interval.meets(from.time, to.time))
      most = std::max(most, length(to.offset - from.offset) / (to.time - from.time));
    from = to;
  }
  return most;
}

double lever(const Extent& extent, const scene::MotionShape& motion) {
  const auto* turn = std::get_if<scene::MotionRotation>(&motion);
  if (turn == nullptr || extent.empty) return 0;
  double most = 0;  // the distance from a line is convex: largest at a corner
  for (const Vec3d& corner : extent.corners()) most = std::max(most, from_axis(*turn, corner));
  return most;
}

/// Whether a collider is one of Assets::objects.
bool is_object(const scene::Collider& collider) {
  return !std::holds_alternative<scene::ColliderSphere>(collider) &&
         !std::holds_alternative<scene::ColliderCapsule>(collider) &&
         !std::holds_alternative<scene::ColliderPlane>(collider);
}

double fastest(const std::vector<Vec3f>& from, const std::vector<Vec3f>& to, double duration) {
  double most = 0;
  for (std::size_t v = 0; v < from.size(); ++v)
    most = std::max(most, length(to[v].to<double>() - from[v].to<double>()));
  return most / duration;
}

}  // namespace

void Extent::add(const Vec3d& point) {
  low = empty ? point : min(low, point);
  high = empty ? point : max(high, point);
  empty = false;
}
void Extent::add_ball(const Vec3d& center, double radius) {
  add(center - Vec3d{radius, radius, radius});
  add(center + Vec3d{radius, radius, radius});
}
std::array<Vec3d, 8> Extent::corners() const {
  std::array<Vec3d, 8> all;
  for (std::size_t k = 0; k < 8; ++k)
    all[k] = {(k & 1U) != 0 ? high.x : low.x, (k & 2U) != 0 ? high.y : low.y, (k & 4U) != 0 ? high.z : low.z};
  return all;
}

std::vector<Extent> collider_extents(const scene::Scene& scene, const Model& model,
                                     std::span<const mesh::TriangleMesh> objects,
                                     std::span<const mesh::Deformation> deformations) {
  Extent cloths;
  for (const Vec3d& rest : model.rest_position) cloths.add(rest);
  std::vector<Extent> extents;
  std::size_t object = 0;
  for (const scene::Collider& collider : scene.colliders) {
    Extent extent;
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) {
      extent.add_ball(sphere->center, sphere->radius);
    } else if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&collider)) {
      extent.add_ball(capsule->a, capsule->radius);
      extent.add_ball(capsule->b, capsule->radius);
    } else if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) {
      extent = cloths;
      extent.add(plane->point);
    } else {
      for (const Vec3f& p : objects[object].positions) extent.add(p.to<double>());
      if (object < deformations.size())
        for (const std::vector<Vec3f>& shape : deformations[object].shapes)
          for (const Vec3f& p : shape) extent.add(p.to<double>());
      ++object;
    }
    extents.push_back(extent);
  }
  for (std::size_t v = 0; v < model.vertex_count(); ++v) {
    if (model.motion[v] < 2) continue;
    const auto* carried = std::get_if<scene::MotionCarried>(&model.motions[model.motion[v] - 2].shape);
    if (carried != nullptr) extents[carried->collider].add(model.rest_position[v]);
  }
  return extents;
}

std::vector<ContactMover> contact_movers(const scene::Scene& scene, const Model& model,
                                         std::span<const mesh::TriangleMesh> objects,
                                         std::span<const mesh::Deformation> deformations,
                                         bool holds_obstacles) {
  std::vector<ContactMover> movers;
  std::vector<Extent> moved(model.motions.size());
  for (std::size_t v = 0; v < model.vertex_count(); ++v)
    if (model.motion[v] > 1) moved[model.motion[v] - 2].add(model.rest_position[v]);
  for (std::size_t m = 0; m < moved.size(); ++m)
    movers.push_back({.motion = model.motions[m].shape, .lever = lever(moved[m], model.motions[m].shape)});
  const std::vector<Extent> extents = collider_extents(scene, model, objects, deformations);
  std::size_t object = 0;
  for (std::size_t c = 0; c < scene.colliders.size(); ++c) {
    const scene::Collider& collider = scene.colliders[c];
    ContactMover mover;
    if (holds_obstacles) mover.travel = 2;
    mover.motion = scene::motion_of(collider);
    if (is_object(collider)) {
      const std::vector<Vec3f>* before = &objects[object].positions;
      double time = 0;
      for (std::size_t k = 0; object < deformations.size() && k < deformations[object].shapes.size(); ++k) {
        const std::vector<Vec3f>& shape = deformations[object].shapes[k];
        const double next = deformations[object].times.times[k];
        mover.changes.push_back({next, fastest(*before, shape, next - time)});
        mover.loops = deformations[object].times.loops;
        before = &shape;
        time = next;
      }
      ++object;
    }
    if (mover.motion) mover.lever = lever(extents[c], *mover.motion);
    if (mover.motion || !mover.changes.empty()) movers.push_back(std::move(mover));
  }
  return movers;
}

namespace {

double largest_change(const ContactMover& mover, double begin, double end) {
  if (mover.changes.empty()) return 0;
  const Interval interval(begin, end, mover.loops ? std::optional(mover.changes.back().time) : std::nullopt);
  double most = 0, from = 0;
  for (const ContactMover::Change& one : mover.changes) {
    if (interval.meets(from, one.time)) most = std::max(most, one.speed);
    from = one.time;
  }
  return most;
}

}  // namespace

double largest_speed(const ContactMover& mover, double begin, double end) {
  double speed = 0;
  if (mover.motion) {
    if (const auto* line = std::get_if<scene::MotionLine>(&*mover.motion)) {
      speed = profile_speed(begin - line->start, end - line->start, line->speed, line->ramp, line->distance);
    } else if (const auto* path = std::get_if<scene::MotionPath>(&*mover.motion)) {
      speed = path_speed(*path, begin, end);
    } else if (const auto* turn = std::get_if<scene::MotionRotation>(&*mover.motion)) {
      speed = mover.lever *
              profile_speed(begin - turn->start, end - turn->start, turn->speed, turn->ramp, turn->angle);
    } else if (const auto* given = std::get_if<scene::MotionGiven>(&*mover.motion)) {
      speed = given->speed;
    } else if (const auto* carried = std::get_if<scene::MotionCarried>(&*mover.motion)) {
      speed = carried->speed;
    }
  }
  return speed + largest_change(mover, begin, end);
}

double largest_speed(std::span<const ContactMover> movers, double begin, double end) {
  double speed = 0;
  for (const ContactMover& mover : movers) speed = std::max(speed, largest_speed(mover, begin, end));
  return speed;
}

std::uint32_t contact_step_factor(std::span<const ContactMover> movers, double begin, double end,
                                  double thickness, double step) {
  double most = 0;
  for (const ContactMover& mover : movers)
    most = std::max(most, largest_speed(mover, begin, end) * step / (mover.travel * thickness));
  const double factor = std::ceil(most * (1 - 1e-12));  // an even bound is not rounded up
  if (!(factor > 1)) return 1;
  return factor < kMostContactSteps ? static_cast<std::uint32_t>(factor) : kMostContactSteps;
}

}  // namespace weft
