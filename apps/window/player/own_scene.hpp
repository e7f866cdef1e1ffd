// A scene from a mesh that was dropped: what the page makes of one too (apps/web/src/files/own_scene.ts).
#pragma once

#include <string>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::window {

inline constexpr char kOwnMesh[] = "own.ply";  // by which the scene calls the mesh

enum class Role { Obstacle, Cloth };

/// A mesh that was brought, without triangles that have no area and vertices that have no triangle.
struct OwnMesh {
  std::string name;  // of its file
  mesh::TriangleMesh mesh;
  std::size_t dropped = 0;  // triangles without area
  mesh::Bounds box;         // [unit of the file]
  double area = 0;          // the same, squared

  double longest_side() const;
  /// Whether it is small enough: the limits of the page, so that what opens there opens here.
  bool may_be(Role role) const;
};

inline constexpr double kLeastLength = 0.1, kMostLength = 10, kFirstLength = 1.2;  // of the longest side [m]

/// Errors  Input: it is no mesh; none of its triangles has an area. Limit: it is too large for either role.
Result<OwnMesh> read_own_mesh(const std::string& path);

/// The JSON of the scene: a square sheet falls on the mesh, which stands on a floor, or the mesh is a cloth that falls
/// on a ball. `length`: of the mesh's longest side [m].
std::string scene_of_mesh(const OwnMesh& mesh, Role role, double length);

}  // namespace weft::window
