// How many times finer a frame must be stepped where something is moved fast: one rule for the GPU and for
// the reference.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/deformation.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// The box around points; of none empty [m].
struct Extent {
  bool empty = true;
  Vec3d low, high;

  void add(const Vec3d& point);
  void add_ball(const Vec3d& center, double radius);
  std::array<Vec3d, 8> corners() const;
};

/// Around each collider where the scene puts it, in all its shapes; of a plane, around its point and the cloths at
/// rest. What is attached to a collider is with it. `objects` and `deformations` as of contact_movers.
std::vector<Extent> collider_extents(const scene::Scene& scene, const Model& model,
                                     std::span<const mesh::TriangleMesh> objects,
                                     std::span<const mesh::Deformation> deformations);

/// Something that a scene moves: a collider, or the nodes of a cloth's motion.
struct ContactMover {
  std::optional<scene::MotionShape> motion;
  double lever = 0;  // of its farthest point from the axis that it turns about [m]
  /// Of a mesh that deforms: up to each time, how fast its fastest vertex goes from the shape before.
  struct Change {
    double time = 0;   // [s]
    double speed = 0;  // [m/s]
  };
  std::vector<Change> changes;
  bool loops = false;   // after the last change the first follows
  double travel = 0.5;  // how far it may go in a substep, in thicknesses
};

/// All that the scene moves. `objects` has the mesh of each mesh and box among the colliders, placed as at
/// time 0, in their order, and `deformations` how each deforms, or nothing. A plane that turns is as long as
/// the cloths at rest are far from its axis. Nothing goes farther in a substep than half a thickness, so that what it
/// strikes between two layers does not have to move farther than they are apart; but obstacles may go by two before a
/// method that answers them itself (`holds_obstacles`): it moves cloth out of their way before contact looks at it, and
/// an obstacle that flies into cloth then does to it what it does to cloth that flies into the obstacle.
std::vector<ContactMover> contact_movers(const scene::Scene& scene, const Model& model,
                                         std::span<const mesh::TriangleMesh> objects,
                                         std::span<const mesh::Deformation> deformations,
                                         bool holds_obstacles = false);

/// The most that any point of the mover may do between two times [m/s]: a bound, by the largest speed of its
/// motion in that time.
double largest_speed(const ContactMover& mover, double begin, double end);
/// The same of the fastest of several.
double largest_speed(std::span<const ContactMover> movers, double begin, double end);

inline constexpr std::uint32_t kMostContactSteps = 4096;
/// The factor for the substeps between two times [s], `step` [s] long, so that no mover goes farther than it may in
/// one, for this thickness [m]. At least 1, at most kMostContactSteps.
std::uint32_t contact_step_factor(std::span<const ContactMover> movers, double begin, double end,
                                  double thickness, double step);

}  // namespace weft
