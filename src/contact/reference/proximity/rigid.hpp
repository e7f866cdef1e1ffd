// Rigid bodies in double: how they move in a substep, and how they meet obstacles and each other.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/rules/rigid_body.hpp"

namespace weft::reference {

/// About a body's centre where its way ends.
struct RigidImpulse {
  Vec3d linear, angular;  // [N·s], [N·m·s]
};

/// A body as impulses of the substep see it.
struct Movable {
  double inverse_mass = 0;  // [1/kg]; 0: it is none
  Mat3 inverse_inertia{};   // [1/(kg m²)]
  Vec3d place;              // of its centre where its way ends [m]
  Vec3d velocity, spin;     // before impulses of cloth [m/s], [rad/s]

  Vec3d velocity_at(const Vec3d& point) const { return velocity + cross(spin, point - place); }
  /// How the velocity at the end of `arm` changes with an impulse there [1/kg].
  Mat3 mobility(const Vec3d& arm) const {
    const Mat3 turn = Mat3::cross(arm);
    return Mat3::identity(inverse_mass) + turn * inverse_inertia * transposed(turn);
  }
};

class RigidBodies {
 public:
  RigidBodies() = default;
  RigidBodies(const scene::Scene& scene, std::span<const mesh::TriangleMesh> objects);

  bool empty() const { return !any_; }
  void reset();
  /// What moves them until the next time; `start` and `end`: where the scene puts each collider in the substep.
  struct Way {
    double dt = 0;           // [s]
    Vec3d load;              // gravity and the external force [m/s²]
    double restitution = 0;  // e
    double thickness = 0;    // of contact [m]
    std::span<const scene::RigidTransform> start, end;
  };
  /// Gives gravity and the impulses of what they touch, and finds where that takes them.
  void go(const Way& way);
  /// Of each collider; only of rigid ones.
  const std::vector<std::optional<scene::RigidTransform>>& starts() const { return starts_; }
  const std::vector<std::optional<scene::RigidTransform>>& ends() const { return ends_; }
  const std::vector<Movable>& movables() const { return movables_; }
  /// Whether cloth that presses a body in this direction bears it as it did in the substep before.
  bool bears(std::size_t collider, const Vec3d& direction) const;
  /// They are where their ways end, with the impulses of cloth, of which `part` counts, and the pushes [m], [rad].
  /// `lacks`: of each, by how much at most cloth that lies there and bears it (bears) is too near to it [m]; none: none
  /// does.
  void arrive(std::span<const RigidImpulse> impulses, std::span<const RigidImpulse> pushes,
              std::span<const std::optional<double>> lacks, double part, double dt);

  const std::vector<ColliderSolid>& solids() const { return solids_; }
  /// Of each collider.
  std::vector<RigidState>& states() { return states_; }
  const std::vector<RigidState>& states() const { return states_; }

 private:
  struct Pose {
    Vec3d place;
    Mat3 turn;
  };
  /// A place where a body touches another collider, and the impulse on it.
  struct Touch {
    std::size_t body = 0, other = 0;
    Vec3d point, normal;  // toward the body
    double gap = 0;       // [m]
    double least = 0;     // normal velocity that is wanted [m/s]
    double friction = 0;
    Vec3d other_velocity;  // of what the scene moves [m/s]
    Vec3d impulse;
  };
  void find_touches(const Way& way);
  void add_touches(std::size_t body, std::size_t other, std::vector<Touch>& found) const;
  void answer_touches(const Way& way);
  Vec3d relative_velocity(const Touch& touch) const;
  void give(const Touch& touch, const Vec3d& impulse);

  std::vector<ColliderSolid> solids_;
  std::vector<RigidState> states_;
  std::vector<Pose> poses_;   // at the start of the substep
  std::vector<Movable> now_;  // the same, with velocities as touches have changed them
  std::vector<Movable> movables_;
  std::vector<Quaternion> turns_;  // where ways end
  std::vector<Touch> touches_;
  /// What cloth has given each when it last bore it [N·s], 0 where none lies at it; and by how much it is too near [m].
  std::vector<Vec3d> lifts_;
  std::vector<double> lacks_;
  std::vector<std::optional<scene::RigidTransform>> starts_, ends_;
  bool any_ = false;
};

/// The greater eigenvalue of a symmetric matrix in the plane square to n, unit.
double most_along(const Mat3& matrix, const Vec3d& n);

}  // namespace weft::reference
