#include "contact/rules/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/trig.hpp"
#include "mesh/mass_moments.hpp"

namespace weft {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A rotation that takes `from`, unit, to `to`, unit.
Quaternion between(const Vec3d& from, const Vec3d& to) {
  const double cosine = dot(from, to);
  if (cosine < -0.999999) {  // half a turn about anything square to it
    const Vec3d other = std::abs(from.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d axis = cross(from, other) / length(cross(from, other));
    return {axis.x, axis.y, axis.z, 0};
  }
  const Vec3d c = cross(from, to);
  const double w = 1 + cosine, size = std::sqrt(dot(c, c) + w * w);
  return {c.x / size, c.y / size, c.z / size, w / size};
}

double volume_of(const ColliderSolid& solid, double hull_volume) {
  const double r = solid.radius;
  switch (solid.kind) {
    case SolidKind::Ball:
      return 4.0 / 3.0 * kPi * r * r * r;
    case SolidKind::Capsule:
      return kPi * r * r * (2 * solid.half.x) + 4.0 / 3.0 * kPi * r * r * r;
    case SolidKind::Box:
      return 8 * solid.half.x * solid.half.y * solid.half.z;
    default:
      return hull_volume;
  }
}

/// Of a unit of mass [m²].
Vec3d inertia_by_mass(const ColliderSolid& solid) {
  const double r = solid.radius;
  if (solid.kind == SolidKind::Ball) return (0.4 * r * r) * Vec3d{1, 1, 1};
  if (solid.kind == SolidKind::Box) {
    const Vec3d square{solid.half.x * solid.half.x, solid.half.y * solid.half.y, solid.half.z * solid.half.z};
    return Vec3d{square.y + square.z, square.x + square.z, square.x + square.y} / 3;
  }
  // A capsule: a cylinder, and a ball cut in two.
  const double length = 2 * solid.half.x, cylinder = kPi * r * r * length, ball = 4.0 / 3.0 * kPi * r * r * r;
  const double part = cylinder / (cylinder + ball), rest = 1 - part;
  const double across = part * (length * length / 12 + r * r / 4) +
                        rest * (0.4 * r * r + length * length / 4 + 0.375 * length * r);
  return {part * 0.5 * r * r + rest * 0.4 * r * r, across, across};
}

constexpr double kSharp = 1e-6;  // by which the cosine between faces is less than 1 where there is an edge

/// A hull's corners, faces, and edges at which its surface turns, about its centre of mass, along its principal axes.
/// Returns its volume, and its inertia by mass.
std::pair<double, Vec3d> set_hull(ColliderSolid& solid, const mesh::TriangleMesh& hull) {
  const mesh::MassMoments moments = mesh::mass_moments(hull);
  const mesh::PrincipalAxes principal = mesh::principal_axes(mesh::inertia_of(moments));
  solid.center = moments.center;
  solid.axes = quaternion_of(principal.axes);
  const Mat3 to_own = transposed(principal.axes);
  for (const Vec3f& p : hull.positions) {
    solid.points.push_back(to_own * (p.to<double>() - moments.center));
    solid.extent = std::max(solid.extent, length(solid.points.back()));
  }
  std::map<std::array<std::uint32_t, 2>, Vec3d>
      open;  // by the ends of a side, the normal of its first triangle
  for (const mesh::Triangle& corner : hull.triangles) {
    const Vec3d &a = solid.points[corner[0]], &b = solid.points[corner[1]], &c = solid.points[corner[2]];
    const Vec3d out = cross(b - a, c - a);
    const Vec3d n = length(out) > 0 ? out / length(out) : Vec3d{};
    if (length(out) > 0) solid.planes.push_back({n.x, n.y, n.z, dot(n, a)});
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [first, second] = std::minmax(corner[k], corner[(k + 1) % 3]);
      const auto [side, is_new] = open.try_emplace({first, second}, n);
      if (!is_new && dot(side->second, n) < 1 - kSharp)
        solid.edges.push_back({solid.points[first], solid.points[second]});
    }
  }
  return {moments.volume, principal.values / moments.volume};
}

}  // namespace

std::vector<ColliderSolid> solids_of(const scene::Scene& scene, std::span<const mesh::TriangleMesh> objects,
                                     std::span<const std::size_t> object_colliders) {
  std::vector<ColliderSolid> solids;
  for (std::size_t c = 0; c < scene.colliders.size(); ++c) {
    const scene::Collider& collider = scene.colliders[c];
    ColliderSolid solid;
    double hull_volume = 0;
    Vec3d hull_inertia;
    if (const auto& friction = scene::friction_of(collider)) solid.friction = *friction;
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) {
      solid.kind = SolidKind::Ball;
      solid.center = sphere->center;
      solid.radius = solid.extent = sphere->radius;
    } else if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&collider)) {
      solid.kind = SolidKind::Capsule;
      solid.center = 0.5 * (capsule->a + capsule->b);
      const double axis = length(capsule->b - capsule->a);
      solid.axes = between({1, 0, 0}, (capsule->b - capsule->a) / axis);
      solid.half = {0.5 * axis, 0, 0};
      solid.radius = capsule->radius;
      solid.extent = 0.5 * axis + capsule->radius;
    } else if (const auto* box = std::get_if<scene::ColliderBox>(&collider)) {
      solid.kind = SolidKind::Box;
      solid.center = box->center;
      solid.axes = box->rotate;
      solid.half = 0.5 * box->size;
      solid.extent = length(solid.half);
    } else if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) {
      solid.kind = SolidKind::Plane;
      solid.center = plane->point;
      solid.axes = between({0, 1, 0}, plane->normal);
    } else if (std::holds_alternative<scene::ColliderConvex>(collider)) {
      const auto found = std::find(object_colliders.begin(), object_colliders.end(), c);
      if (found != object_colliders.end()) {
        solid.kind = SolidKind::Hull;
        std::tie(hull_volume, hull_inertia) =
            set_hull(solid, objects[static_cast<std::size_t>(found - object_colliders.begin())]);
      }
    }
    if (const scene::Rigid* rigid = scene::rigid_of(collider)) {
      solid.mass = rigid->mass ? *rigid->mass : *rigid->density * volume_of(solid, hull_volume);
      solid.inertia = solid.mass * (solid.kind == SolidKind::Hull ? hull_inertia : inertia_by_mass(solid));
      solid.velocity = rigid->velocity;
      solid.spin = rigid->spin;
    }
    solids.push_back(std::move(solid));
  }
  return solids;
}

double lightest_rigid(std::span<const ColliderSolid> solids) {
  double least = 0;
  for (const ColliderSolid& solid : solids)
    if (solid.rigid() && (least == 0 || solid.mass < least)) least = solid.mass;
  return least;
}

RigidState start_of(const ColliderSolid& solid) {
  RigidState state{solid.center, solid.axes, solid.velocity, {}, {}, {}};
  const Mat3 turn = matrix_of(solid.axes);
  const Vec3d own = transposed(turn) * solid.spin;
  state.momentum = turn * Vec3d{solid.inertia.x * own.x, solid.inertia.y * own.y, solid.inertia.z * own.z};
  return state;
}

Mat3 inverse_inertia(const ColliderSolid& solid, const Quaternion& turn) {
  const Mat3 r = matrix_of(turn);
  const Mat3 own{{1 / solid.inertia.x, 0, 0}, {0, 1 / solid.inertia.y, 0}, {0, 0, 1 / solid.inertia.z}};
  return r * own * transposed(r);
}

Vec3d spin_of(const ColliderSolid& solid, const RigidState& state) {
  return inverse_inertia(solid, state.turn) * state.momentum;
}

double kinetic_energy(const ColliderSolid& solid, const RigidState& state) {
  return 0.5 * solid.mass * dot(state.velocity, state.velocity) +
         0.5 * dot(state.momentum, spin_of(solid, state));
}

scene::RigidTransform transform_of(const ColliderSolid& solid, const Vec3d& place, const Quaternion& turn) {
  const Mat3 r = matrix_of(turn) * transposed(matrix_of(solid.axes));
  scene::RigidTransform transform;
  const Vec3d* rows[] = {&r.x, &r.y, &r.z};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) transform.rotation[3 * row + column] = (*rows[row])[column];
  transform.translation = place - r * solid.center;
  return transform;
}

Quaternion turned_by(const Quaternion& turn, const Vec3d& angle) {
  const double size = length(angle);
  if (!(size > 0)) return turn;
  const Turn half = turn_of(0.5 * size);
  const Vec3d axis = (half.sine / size) * angle;
  Quaternion q = product({axis.x, axis.y, axis.z, half.cosine}, turn);
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= norm;
  return q;
}

Quaternion turned_freely(const Vec3d& inertia, const Quaternion& turn, const Vec3d& momentum, double step) {
  // The middle moment of inertia turns all about L; what the other two differ by turns about their own axes. Where two
  // moments are equal the middle one is one of them, only one part is left, and the whole is exact.
  int a = 0, b = 1, c = 2;
  if (inertia[a] > inertia[b]) std::swap(a, b);
  if (inertia[b] > inertia[c]) std::swap(b, c);
  if (inertia[a] > inertia[b]) std::swap(a, b);
  std::swap(a, b);  // a is the middle one
  Quaternion q = turned_by(turn, (step / inertia[a]) * momentum);
  const auto turn_own = [&](int axis, double time) {
    const double along = (transposed(matrix_of(q)) * momentum)[axis];
    const Turn half = turn_of(0.5 * along * (1 / inertia[axis] - 1 / inertia[a]) * time);
    Quaternion own{0, 0, 0, half.cosine};
    own[static_cast<std::size_t>(axis)] = half.sine;
    q = product(q, own);
  };
  turn_own(b, 0.5 * step);
  turn_own(c, step);
  turn_own(b, 0.5 * step);
  return q;
}

double rigid_friction(double a, double b) {
  if (a >= 0 && b >= 0) return std::sqrt(a * b);
  return a >= 0 ? a : b >= 0 ? b : kRigidFriction;
}

}  // namespace weft
