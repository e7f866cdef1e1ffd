// The colliders of a scene as features that move, in double.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/reference/proximity/pairs.hpp"
#include "mesh/curvature.hpp"
#include "mesh/deformation.hpp"
#include "scene/motion.hpp"
#include "scene/scene.hpp"

namespace weft::reference {

class Obstacles {
 public:
  /// Where all of them are at a time.
  struct Placed {
    std::vector<scene::RigidTransform> transforms;  // of each collider of the scene
    std::vector<Vec3d> positions;                   // of the features [m]
    std::vector<scene::ColliderPlane> planes;
  };

  Obstacles() = default;
  /// `objects` holds the mesh of each mesh and box among the colliders, placed as at time 0, in their order;
  /// `deformations` how each deforms, or nothing.
  Obstacles(const scene::Scene& scene, std::span<const mesh::TriangleMesh> objects,
            std::span<const mesh::Deformation> deformations);

  bool empty() const { return features_.vertices.empty() && planes_.empty(); }
  /// Whether none ever moves.
  bool still() const { return still_; }
  /// `rigid`: where rigid bodies are, of each collider; else where the scene puts them.
  Placed at(double time, std::span<const std::optional<scene::RigidTransform>> rigid = {}) const;
  /// All but planes, at time 0 before any motion: meshes, then spheres and capsules.
  const Features& features() const { return features_; }

  /// Of the mesh at a vertex, before any motion; none of one that deforms.
  const mesh::Curvature& curvature(std::uint32_t vertex) const { return curvatures_[vertex]; }
  std::uint32_t collider_of_vertex(std::uint32_t vertex) const { return collider_of_vertex_[vertex]; }
  std::uint32_t collider_of_plane(std::uint32_t plane) const { return collider_of_plane_[plane]; }
  const std::optional<double>& friction(std::uint32_t collider) const { return frictions_[collider]; }

 private:
  /// Shapes of the vertices from `first` on.
  struct Deforming {
    std::uint32_t first = 0;
    mesh::ShapeTimes times;
    std::vector<std::vector<Vec3d>> shapes;  // at time 0, then one for each time, before any motion [m]
  };
  void deform(const Deforming& deforming, double time, std::vector<Vec3d>& positions) const;

  Features features_;
  std::vector<mesh::Curvature> curvatures_;
  std::vector<std::uint32_t> collider_of_vertex_, collider_of_plane_;
  std::vector<scene::ColliderPlane> planes_;
  std::vector<std::optional<double>> frictions_;
  std::vector<std::optional<scene::ColliderMotion>> motions_;
  std::vector<Deforming> deforming_;
  bool still_ = true;
};

/// Where a point that moves with a rigid body is at the end, from where it is at the start.
Vec3d carried(const Vec3d& point, const scene::RigidTransform& start, const scene::RigidTransform& end);

}  // namespace weft::reference
