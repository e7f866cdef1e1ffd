#include "contact/reference/proximity/rigid.hpp"

#include <algorithm>
#include <cmath>

#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/proximity/obstacles.hpp"
#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

/// How far a place is from a solid's surface, and the direction out of it; in the solid's own frame.
struct Depth {
  double gap = 0;
  Vec3d out;
};

constexpr double kOnFace = 1e-6;      // of an extent: what is no farther beside a face is on it
constexpr double kSameFace = 0.9999;  // the cosine between triangles of one face of a hull

Depth from_core(const Vec3d& away, double radius) {
  const double size = length(away);
  return {size - radius, size > 0 ? away / size : Vec3d{0, 1, 0}};
}

Depth from_box(const Vec3d& p, const Vec3d& half) {
  Vec3d inner, over;
  for (int axis = 0; axis < 3; ++axis) {
    inner[axis] = std::clamp(p[axis], -half[axis], half[axis]);
    over[axis] = p[axis] - inner[axis];
  }
  if (over != Vec3d{}) return from_core(over, 0);
  int nearest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (half[axis] - std::abs(p[axis]) < half[nearest] - std::abs(p[nearest])) nearest = axis;
  Vec3d out;
  out[nearest] = p[nearest] < 0 ? -1 : 1;
  return {std::abs(p[nearest]) - half[nearest], out};
}

/// By the face that a place is in or above, or else by the nearest edge.
Depth from_hull(const ColliderSolid& solid, const Vec3d& p) {
  Depth most{-1e300, {0, 1, 0}};
  for (const auto& plane : solid.planes) {
    const Vec3d n{plane[0], plane[1], plane[2]};
    if (const double gap = dot(n, p) - plane[3]; gap > most.gap) most = {gap, n};
  }
  if (most.gap <= 0) return most;
  const Vec3d foot = p - most.gap * most.out;
  bool is_above = true;
  for (const auto& plane : solid.planes)
    is_above =
        is_above && dot(Vec3d{plane[0], plane[1], plane[2]}, foot) - plane[3] <= kOnFace * solid.extent;
  if (is_above) return most;
  Depth nearest{1e300, most.out};
  for (const auto& [start, end] : solid.edges) {
    const ClosestOnSegment at = closest_on_segment(p, start, end);
    if (at.distance > 0 && at.distance < nearest.gap) nearest = {at.distance, at.offset / at.distance};
  }
  return nearest;
}

Depth depth_of(const ColliderSolid& solid, const Vec3d& p) {
  switch (solid.kind) {
    case SolidKind::Ball:
      return from_core(p, solid.radius);
    case SolidKind::Capsule:
      return from_core(p - Vec3d{std::clamp(p.x, -solid.half.x, solid.half.x), 0, 0}, solid.radius);
    case SolidKind::Box:
      return from_box(p, solid.half);
    case SolidKind::Plane:
      return {p.y, {0, 1, 0}};
    case SolidKind::Hull:
      return from_hull(solid, p);
    default:
      return {1e300, {0, 1, 0}};
  }
}

/// The points that a solid touches others with, which have its radius.
std::vector<Vec3d> feet_of(const ColliderSolid& solid) {
  const Vec3d& h = solid.half;
  switch (solid.kind) {
    case SolidKind::Ball:
      return {{}};
    case SolidKind::Capsule:
      return {{-h.x, 0, 0}, {h.x, 0, 0}};
    case SolidKind::Box: {
      std::vector<Vec3d> corners;
      for (unsigned k = 0; k < 8; ++k)
        corners.push_back(
            {(k & 1U) != 0 ? h.x : -h.x, (k & 2U) != 0 ? h.y : -h.y, (k & 4U) != 0 ? h.z : -h.z});
      return corners;
    }
    case SolidKind::Hull:
      return solid.points;
    default:
      return {};
  }
}

/// The edges by which solids meet: a capsule's axis, those of boxes and hulls.
std::vector<std::array<Vec3d, 2>> rods_of(const ColliderSolid& solid) {
  if (solid.kind == SolidKind::Capsule) return {{Vec3d{-solid.half.x, 0, 0}, Vec3d{solid.half.x, 0, 0}}};
  if (solid.kind == SolidKind::Hull) return solid.edges;
  std::vector<std::array<Vec3d, 2>> rods;
  if (solid.kind != SolidKind::Box) return rods;
  const std::vector<Vec3d> corners = feet_of(solid);
  for (unsigned k = 0; k < 8; ++k)
    for (unsigned bit = 1; bit < 8; bit *= 2)
      if ((k & bit) == 0) rods.push_back({corners[k], corners[k | bit]});
  return rods;
}

/// A face of a box or a hull, in its own frame.
struct Face {
  Vec3d out;
  double offset = 0;      // out · x = offset
  double apart = -1e300;  // of what is asked about, the least gap to it
};

template <class Take>
void for_faces(const ColliderSolid& solid, const Take& take) {
  if (solid.kind == SolidKind::Hull)
    for (const auto& plane : solid.planes) take(Vec3d{plane[0], plane[1], plane[2]}, plane[3]);
  if (solid.kind != SolidKind::Box) return;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3d out;
      out[axis] = side;
      take(out, solid.half[axis]);
    }
}

/// The face beyond which a solid with these corners lies farthest, or in which it is least deep.
Face face_toward(const ColliderSolid& solid, std::span<const Vec3d> corners) {
  Face best;
  for_faces(solid, [&](const Vec3d& out, double offset) {
    double apart = 1e300;
    for (const Vec3d& corner : corners) apart = std::min(apart, dot(out, corner) - offset);
    if (apart > best.apart) best = {out, offset, apart};
  });
  return best;
}

/// How far a place is beside a face, beyond the nearest of the others.
double beside(const ColliderSolid& solid, const Face& face, const Vec3d& p) {
  double most = -1e300;
  for_faces(solid, [&](const Vec3d& out, double offset) {
    if (dot(out, face.out) < kSameFace) most = std::max(most, dot(out, p) - offset);
  });
  return most;
}

constexpr double kWithinRod = 1e-3;  // of its length: an end has touches of its own
constexpr double kLifts = 0.5;       // the cosine from which on cloth bears a body away from an obstacle
constexpr double kDeepest = 0.05;    // of an extent, that edges may be in each other

}  // namespace

double most_along(const Mat3& matrix, const Vec3d& n) {
  const Vec3d other = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d s = cross(n, other) / length(cross(n, other)), t = cross(n, s);
  const double ss = dot(s, matrix * s), tt = dot(t, matrix * t), st = dot(s, matrix * t);
  return 0.5 * (ss + tt) + std::sqrt(0.25 * (ss - tt) * (ss - tt) + st * st);
}

RigidBodies::RigidBodies(const scene::Scene& scene, std::span<const mesh::TriangleMesh> objects) {
  std::vector<std::size_t> object_colliders;
  for (std::size_t c = 0; c < scene.colliders.size(); ++c)
    if (std::holds_alternative<scene::ColliderMesh>(scene.colliders[c]) ||
        std::holds_alternative<scene::ColliderBox>(scene.colliders[c]) ||
        std::holds_alternative<scene::ColliderConvex>(scene.colliders[c]))
      object_colliders.push_back(c);
  solids_ = solids_of(scene, objects, object_colliders);
  any_ = scene::has_rigid(scene);
  reset();
}

void RigidBodies::reset() {
  lifts_.assign(solids_.size(), {});
  lacks_.assign(solids_.size(), 0);
  states_.clear();
  for (const ColliderSolid& solid : solids_)
    states_.push_back(solid.rigid() ? weft::start_of(solid) : RigidState{});
}

void RigidBodies::add_touches(std::size_t body, std::size_t other, std::vector<Touch>& found) const {
  const ColliderSolid &a = solids_[body], &b = solids_[other];
  const Pose &at = poses_[body], &of = poses_[other];
  const auto add = [&](const Vec3d& point, const Vec3d& normal, double gap) {
    found.push_back({body, other, point, normal, gap, 0, 0, {}, {}});
  };
  if (b.kind == SolidKind::Mesh) return;
  const double deepest = kDeepest * std::min(a.extent, b.extent);
  // The feet of one against the surface of its partner, `side` 1 if that is b.
  const auto add_feet = [&](const ColliderSolid& one, const Pose& one_at, const ColliderSolid& partner,
                            const Pose& partner_at, double side) {
    std::vector<Vec3d> feet;  // in the partner's frame
    for (const Vec3d& foot : feet_of(one))
      feet.push_back(transposed(partner_at.turn) * (one_at.place + one_at.turn * foot - partner_at.place));
    const bool by_face =
        one.radius == 0 && (partner.kind == SolidKind::Box || partner.kind == SolidKind::Hull);
    const Face face = by_face ? face_toward(partner, feet) : Face{};
    for (const Vec3d& foot : feet) {
      Depth depth = depth_of(partner, foot);
      const double out = by_face ? beside(partner, face, foot) : 1e300;
      if (out <= 0 || (out <= kTouchPart * partner.extent && face.apart >= -deepest))
        depth = {dot(face.out, foot) - face.offset, face.out};
      const Vec3d normal = partner_at.turn * depth.out;
      add(partner_at.place + partner_at.turn * foot - one.radius * normal, side * normal,
          depth.gap - one.radius);
    }
  };
  add_feet(a, at, b, of, 1);
  // A ball's one point has been tried; so has a capsule's with a ball, from the ball's side.
  if (a.kind == SolidKind::Ball || b.kind == SolidKind::Plane) return;
  add_feet(b, of, a, at, -1);
  // Whether hardly a corner of a solid is farther along a direction than a place.
  const auto is_farthest = [](const ColliderSolid& solid, const Pose& pose, const Vec3d& n,
                              const Vec3d& place) {
    for (const Vec3d& foot : feet_of(solid))
      if (dot(n, pose.place + pose.turn * foot - place) > kDeepest * solid.extent) return false;
    return true;
  };
  for (const auto& rod : rods_of(a))
    for (const auto& across : rods_of(b)) {
      const Vec3d p = at.place + at.turn * rod[0], u = at.turn * (rod[1] - rod[0]);
      const Vec3d q = of.place + of.turn * across[0], v = of.turn * (across[1] - across[0]);
      const Vec3d square = cross(u, v);
      const double size = dot(square, square);
      if (!(size > 1e-6 * dot(u, u) * dot(v, v))) continue;
      const Vec3d r = q - p;
      const double s = dot(cross(r, v), square) / size, t = dot(cross(r, u), square) / size;
      if (std::min({s, t, 1 - s, 1 - t}) < kWithinRod) continue;
      const Vec3d on_a = p + s * u, on_b = q + t * v;
      Vec3d normal = square / std::sqrt(size);
      if (dot(normal, (on_a - of.place) + (at.place - on_b)) < 0) normal = -normal;
      const double gap = dot(normal, on_a - on_b) - a.radius - b.radius;
      if (gap < -deepest || !is_farthest(a, at, -normal, on_a) || !is_farthest(b, of, normal, on_b)) continue;
      add(on_b + b.radius * normal, normal, gap);
    }
}

Vec3d RigidBodies::relative_velocity(const Touch& touch) const {
  const Vec3d of_other =
      solids_[touch.other].rigid() ? now_[touch.other].velocity_at(touch.point) : touch.other_velocity;
  return now_[touch.body].velocity_at(touch.point) - of_other;
}

void RigidBodies::give(const Touch& touch, const Vec3d& impulse) {
  const auto add = [&](std::size_t body, const Vec3d& amount) {
    Movable& movable = now_[body];
    movable.velocity += movable.inverse_mass * amount;
    movable.spin += movable.inverse_inertia * cross(touch.point - movable.place, amount);
    states_[body].velocity += movable.inverse_mass * amount;
    states_[body].momentum += cross(touch.point - movable.place, amount);
  };
  add(touch.body, impulse);
  if (solids_[touch.other].rigid()) add(touch.other, -impulse);
}

void RigidBodies::find_touches(const Way& way) {
  touches_.clear();
  const double closing = speed_of_load(way.dt, way.load);
  for (std::size_t body = 0; body < solids_.size(); ++body) {
    if (!solids_[body].rigid()) continue;
    std::vector<Touch> found;
    for (std::size_t other = 0; other < solids_.size(); ++other) {
      if (other == body || (solids_[other].rigid() && other < body)) continue;
      add_touches(body, other, found);
    }
    std::vector<Touch> near;
    for (Touch& touch : found) {
      // Where cloth has borne the body away from an obstacle, it lies between them, with its thickness to both.
      if (!solids_[touch.other].rigid() && bears(body, touch.normal))
        touch.gap = std::max(touch.gap - 2 * way.thickness, -lacks_[body]);
      if (!solids_[touch.other].rigid())
        touch.other_velocity =
            (carried(touch.point, way.start[touch.other], way.end[touch.other]) - touch.point) / way.dt;
      const double speed = dot(touch.normal, relative_velocity(touch));
      if (!(touch.gap + std::min(0.0, 2 * way.dt * speed) < kTouchPart * solids_[body].extent)) continue;
      touch.friction = rigid_friction(solids_[body].friction, solids_[touch.other].friction);
      touch.least = -std::max(0.0, touch.gap) / way.dt;
      if (way.restitution > 0 && -speed > closing && touch.gap + way.dt * speed < 0) {
        const double toward = solids_[touch.other].rigid() ? 0 : -way.dt * dot(touch.normal, way.load);
        touch.least = std::max(touch.least, way.restitution * (-speed - toward) - toward);
      }
      if (near.size() < kMostTouches) {
        near.push_back(touch);
        continue;
      }
      const auto farthest = std::max_element(near.begin(), near.end(),
                                             [](const Touch& x, const Touch& y) { return x.gap < y.gap; });
      if (touch.gap < farthest->gap) *farthest = touch;
    }
    touches_.insert(touches_.end(), near.begin(), near.end());
  }
}

/// Impulses one after the other, each of which ends with its least normal velocity or none, and sticks or slides.
void RigidBodies::answer_touches(const Way& way) {
  for (std::uint32_t round = 0; round < kTouchRounds; ++round)
    for (Touch& touch : touches_) {
      const Movable &a = now_[touch.body], &b = now_[touch.other];
      Mat3 mobility = a.mobility(touch.point - a.place);
      if (solids_[touch.other].rigid()) mobility += b.mobility(touch.point - b.place);
      const Vec3d& n = touch.normal;
      const double before = dot(n, touch.impulse);
      const double normal =
          std::max(0.0, before + (touch.least - dot(n, relative_velocity(touch))) / dot(n, mobility * n));
      give(touch, (normal - before) * n);
      const Vec3d u = relative_velocity(touch);
      const Vec3d along = touch.impulse - before * n;
      Vec3d wanted = along - (u - dot(n, u) * n) / most_along(mobility, n);
      if (const double size = length(wanted), most = touch.friction * normal; size > most)
        wanted *= most / size;
      give(touch, wanted - along);
      touch.impulse = normal * n + wanted;
    }
  // What has come into another is moved out of it, without speed.
  const auto depth_of_touch = [&](const Touch& one) {
    return -one.gap - kTouchPart * solids_[one.body].extent;
  };
  for (const Touch& touch : touches_) {
    const double depth = depth_of_touch(touch);
    if (!(depth > 0)) continue;
    const Vec3d out = std::min(kOutPart * depth / way.dt, kOutSpeed) * touch.normal;
    const double a = now_[touch.body].inverse_mass, b = now_[touch.other].inverse_mass;
    const auto of_body = [&](const Touch& one) { return one.body == touch.body && depth_of_touch(one) > 0; };
    const double of_all = 1.0 / static_cast<double>(std::count_if(touches_.begin(), touches_.end(), of_body));
    states_[touch.body].push += (a / (a + b) * of_all) * out;
    if (b > 0) states_[touch.other].push -= (b / (a + b) * of_all) * out;
  }
}

void RigidBodies::go(const Way& way) {
  const std::size_t count = solids_.size();
  poses_.assign(count, {});
  now_.assign(count, {});
  movables_.assign(count, {});
  turns_.assign(count, {});
  starts_.assign(count, {});
  ends_.assign(count, {});
  for (std::size_t c = 0; c < count; ++c) {
    const ColliderSolid& solid = solids_[c];
    if (!solid.rigid()) {
      const double* r = way.start[c].rotation;
      const Mat3 turn{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}};
      poses_[c] = {way.start[c](solid.center), turn * matrix_of(solid.axes)};
      continue;
    }
    RigidState& state = states_[c];
    state.velocity += way.dt * way.load;
    poses_[c] = {state.place, matrix_of(state.turn)};
    now_[c] = {1 / solid.mass, inverse_inertia(solid, state.turn), state.place, state.velocity,
               spin_of(solid, state)};
  }
  find_touches(way);
  answer_touches(way);
  for (std::size_t c = 0; c < count; ++c) {
    const ColliderSolid& solid = solids_[c];
    if (!solid.rigid()) continue;
    const RigidState& state = states_[c];
    const Vec3d place = state.place + way.dt * (state.velocity + state.push);
    turns_[c] =
        turned_by(turned_freely(solid.inertia, state.turn, state.momentum, way.dt), way.dt * state.push_turn);
    starts_[c] = transform_of(solid, state.place, state.turn);
    ends_[c] = transform_of(solid, place, turns_[c]);
    const Mat3 inertia = inverse_inertia(solid, turns_[c]);
    movables_[c] = {1 / solid.mass, inertia, place, state.velocity, inertia * state.momentum};
  }
}

bool RigidBodies::bears(std::size_t collider, const Vec3d& direction) const {
  return dot(lifts_[collider], direction) > kLifts * length(lifts_[collider]);
}

void RigidBodies::arrive(std::span<const RigidImpulse> impulses, std::span<const RigidImpulse> pushes,
                         std::span<const std::optional<double>> lacks, double part, double dt) {
  for (std::size_t c = 0; c < solids_.size(); ++c) {
    if (!solids_[c].rigid()) continue;
    RigidState& state = states_[c];
    const Movable& movable = movables_[c];
    // What an obstacle bears of a body, cloth between both does not: while it lies there, it is as if it bore it.
    if (const Vec3d lift = part * impulses[c].linear; !lacks[c] || length(lift) > length(lifts_[c]))
      lifts_[c] = lift;
    lacks_[c] = lacks[c].value_or(0);
    if (const double lift = length(lifts_[c]); lift > 0)
      lacks_[c] -= dot(movable.place - state.place, lifts_[c]) / lift;
    state.place = movable.place;
    state.turn = turns_[c];
    state.velocity += (part * movable.inverse_mass) * impulses[c].linear;
    state.momentum += part * impulses[c].angular;
    state.push = (movable.inverse_mass / dt) * pushes[c].linear;
    state.push_turn = (1 / dt) * (movable.inverse_inertia * pushes[c].angular);
  }
}

}  // namespace weft::reference
