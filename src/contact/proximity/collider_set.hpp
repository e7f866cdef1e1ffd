// The colliders of a scene as proximity contact sees them: points that may move, and the features between them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "contact/proximity/implicit_tree.hpp"
#include "mesh/deformation.hpp"
#include "scene/scene.hpp"

namespace weft::contact {

/// The kinds of src/contact/proximity/find_pairs.wgsl, in its order.
enum class ColliderKind : std::uint32_t { Tree, Implicit, Sphere, Capsule, Plane };
inline constexpr std::uint32_t kMostColliders = 1024;

/// Mirror of ColliderPlace in src/contact/proximity/move_points.wgsl: where a collider is at one time.
struct ColliderPlace {
  std::array<Vec4f, 3> rows;  // x, y, z of R·p + t
  Vec4f shape;                // first point of the shape before and of the one after, how far between
  Vec4f spin;                 // [rad/s]
};
static_assert(sizeof(ColliderPlace) == 80);

/// A mesh or box of the scene, placed as at time 0.
struct ColliderMeshes {
  std::span<const mesh::TriangleMesh> objects;
  std::span<const std::size_t> object_colliders;    // of the scene, for each object
  std::span<const mesh::Deformation> deformations;  // of each object
};

/// A mesh that deforms, as a part of the shapes.
struct DeformingCollider {
  std::size_t collider = 0;  // of the scene
  std::uint32_t first_point = 0, point_count = 0;
  std::uint32_t first_shape = 0;  // its points at its first time
  mesh::ShapeTimes times;
};

struct ColliderSet {
  std::vector<TreeWord> list;  // a collider each: kind, and three numbers
  /// All at time 0 with radii (negative: of a mesh that faces outward), again with friction; then two each for how its
  /// mesh is curved (curved.wgsl): xx, yy, zz of dn/dx and the normal; xy, xz, yz and its collider; then 4 rows a
  /// collider.
  std::vector<Vec4f> points;
  std::vector<mesh::Triangle> faces;  // of all meshes, by points
  std::vector<float> rims;            // of each point of a mesh: how far it lies from the mesh's rim [m]
  std::vector<Vec4f> shapes;          // points, then those of other shapes; w: collider + kind of point
  std::vector<DeformingCollider> deforming;
  std::vector<TreeWord> trees;                                // behind the cloths' tree
  std::vector<TreeWord> triangles;                            // of deforming meshes, behind the cloths'
  std::vector<ImplicitTree> implicit;                         // their trees
  std::vector<std::uint32_t> implicit_first, implicit_count;  // and which triangles they are of
  std::uint32_t point_count = 0;
  bool moves = false;

  /// `first_word` and `first_triangle` are the later places of `trees` and `triangles`.
  /// Errors  Input: a triangle has no area, a radius is not positive. Limit: too many colliders, a tree that
  /// is too deep.
  static Result<ColliderSet> create(const scene::Scene& scene, const ColliderMeshes& meshes,
                                    std::uint32_t first_word, std::uint32_t first_triangle);
};

/// Where the colliders are at a time; `spin` is that of the step that begins then.
void place_colliders(const scene::Scene& scene, const ColliderSet& set, double time, double step,
                     std::span<ColliderPlace> places);

}  // namespace weft::contact
