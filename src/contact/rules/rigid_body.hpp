// Colliders as solids, and the masses of those that are rigid bodies: one rule for the GPU and for the reference.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/mat3.hpp"
#include "base/quaternion.hpp"
#include "mesh/triangle_mesh.hpp"
#include "scene/motion.hpp"
#include "scene/scene.hpp"

namespace weft {

/// Mesh: rigid bodies do not meet it.
enum class SolidKind : std::uint32_t { Ball, Capsule, Box, Hull, Plane, Mesh };

/// A collider as rigid bodies meet it. What has a place is in its own frame: about its centre, a box and a rigid body
/// along its principal axes, a capsule's axis along x, a plane's normal along y.
struct ColliderSolid {
  SolidKind kind = SolidKind::Mesh;
  Vec3d center;                 // where the scene puts it; of a plane its point [m]
  Quaternion axes{0, 0, 0, 1};  // from its own frame to where the scene puts it
  Vec3d half;                   // of a box, half its edges; of a capsule, x: half its axis [m]
  double radius = 0;            // of a ball or capsule [m]
  std::vector<Vec3d> points;    // corners of a hull [m]
  std::vector<std::array<double, 4>>
      planes;                               // of a hull's faces: outward normal, how far from the centre [m]
  std::vector<std::array<Vec3d, 2>> edges;  // of a hull, between faces that differ [m]
  double extent = 0;                        // no point is farther from the centre [m]
  double friction = -1;                     // negative: it has none of its own
  // Of a rigid body; else 0.
  double mass = 0;       // [kg]
  Vec3d inertia;         // about its own axes [kg m²]
  Vec3d velocity, spin;  // at the start [m/s], [rad/s]

  bool rigid() const { return mass > 0; }
};

/// All colliders of a scene; `objects` and `object_colliders` as of Assets.
std::vector<ColliderSolid> solids_of(const scene::Scene& scene, std::span<const mesh::TriangleMesh> objects,
                                     std::span<const std::size_t> object_colliders);

/// The least mass of the rigid ones; 0: there are none [kg].
double lightest_rigid(std::span<const ColliderSolid> solids);

/// How a rigid body is, in its own frame's terms.
struct RigidState {
  Vec3d place;                  // of its centre of mass [m]
  Quaternion turn{0, 0, 0, 1};  // from its own frame to the world
  Vec3d velocity;               // [m/s]
  Vec3d momentum;               // angular, about its centre [kg m²/s]
  Vec3d push, push_turn;        // by which its next way is another than its velocity's [m/s], [rad/s]
};
/// At the start of a scene.
RigidState start_of(const ColliderSolid& solid);
/// Of what turns so, by an angular momentum L: ω = R I⁻¹ Rᵀ L [rad/s].
Vec3d spin_of(const ColliderSolid& solid, const RigidState& state);
/// R I⁻¹ Rᵀ [1/(kg m²)].
Mat3 inverse_inertia(const ColliderSolid& solid, const Quaternion& turn);
/// 1/2 m v² + 1/2 L ω [J].
double kinetic_energy(const ColliderSolid& solid, const RigidState& state);
/// From where the scene puts it to where it is.
scene::RigidTransform transform_of(const ColliderSolid& solid, const Vec3d& place, const Quaternion& turn);

/// How a body that nothing touches turns in a step: L stays, and energy is kept without drift, since each part of the
/// rotation is exact. docs/rigid.md, equation (2).
Quaternion turned_freely(const Vec3d& inertia, const Quaternion& turn, const Vec3d& momentum, double step);
/// Turned by a vector's length about it [rad], in the world.
Quaternion turned_by(const Quaternion& turn, const Vec3d& angle);

/// Rounds of impulses between rigid bodies and what they touch, and how many touches a body has at most.
inline constexpr std::uint32_t kTouchRounds = 12, kMostTouches = 16;
/// Friction between two colliders that give none.
inline constexpr double kRigidFriction = 0.3;
/// Of a body's extent: what is no farther is touched, and may be that deep in it.
inline constexpr double kTouchPart = 1e-3;
/// What has come deeper into another is brought out by this part in a substep, and at most so fast [m/s].
inline constexpr double kOutPart = 0.2, kOutSpeed = 0.5;

/// Of two colliders: the given one, of two their geometric mean.
double rigid_friction(double a, double b);

}  // namespace weft
