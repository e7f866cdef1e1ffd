// Invariants that contact must keep, measured without it: no surface passes through another, no vertex
// is inside, and how near the nearest features are. In double, for tests and host tools.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/reference/box_tree.hpp"
#include "mesh/triangle_mesh.hpp"
#include "scene/scene.hpp"

namespace weft::reference {

/// Positions and the triangles over them: all cloths, or all objects, as one.
struct Surfaces {
  std::span<const Vec3d> positions;  // [m]
  std::span<const mesh::Triangle> triangles;
};
std::vector<Vec3d> widened(std::span<const Vec3f> positions);
/// In f32: a state as the GPU stores it.
std::vector<Vec3d> rounded_to_f32(std::span<const Vec3d> positions);

/// The box of a feature's vertices; not finite if one of them is not.
Box box_of(std::span<const Vec3d> positions, std::span<const std::uint32_t> vertices);

/// Two triangles that pass through each other: numbers in their meshes.
struct Crossing {
  std::uint32_t a = 0, b = 0;
  auto operator<=>(const Crossing&) const = default;
};

/// Whether the segment from p to q passes through the inside of the triangle: its ends are on different
/// sides, and it has all edges on one side. By exact signs: what only touches (an end in the triangle, a
/// segment in its plane or through its border) does not cross, and nothing that crosses is missed.
bool segment_crosses(const Vec3d& p, const Vec3d& q, const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// The pairs (cloth, object) of triangles of which an edge of one crosses the other, sorted. Triangles that
/// are not finite cross nothing.
std::vector<Crossing> crossings(const Surfaces& cloth, const Surfaces& object);
/// The same of one cloth or several with themselves, a < b. An edge is not tested against a triangle with
/// which it shares a vertex: neighbours always meet there.
std::vector<Crossing> self_crossings(const Surfaces& cloth);
/// The same without a tree, for tests of it.
std::vector<Crossing> crossings_by_brute_force(const Surfaces& cloth, const Surfaces& object);
std::vector<Crossing> self_crossings_by_brute_force(const Surfaces& cloth);

/// The vertices inside a body, and the depth of the deepest below its surface.
struct Inside {
  std::uint32_t count = 0;
  double deepest = 0;  // [m]
};
/// Of a closed mesh that faces outward, by its winding number.
Inside inside_mesh(std::span<const Vec3d> positions, const mesh::TriangleMesh& mesh);
/// Of a capsule with this axis; of a sphere where both ends are its centre.
Inside inside_capsule(std::span<const Vec3d> positions, const Vec3d& a, const Vec3d& b, double radius);
Inside below_plane(std::span<const Vec3d> positions, const scene::ColliderPlane& plane);

/// The least distance of a vertex from a triangle and of an edge from an edge, one of cloth and one of the
/// object; infinite where one of them is empty [m].
double least_distance(const Surfaces& cloth, const Surfaces& object);
/// The same of cloth from itself, of features that share no vertex.
double least_self_distance(const Surfaces& cloth);

}  // namespace weft::reference
