// The pairs of cloth and object triangles that intersect, for whole frames.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/reference/pushes/crossing.hpp"
#include "contact/reference/pushes/pairs.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::reference {

/// The triangles of an object, and a tree of boxes over them.
class ObjectTriangles {
 public:
  /// `object` is finite.
  explicit ObjectTriangles(const mesh::TriangleMesh& object);

  /// The pairs whose boxes overlap and which cross, sorted. Triangles that are not finite have none.
  std::vector<TrianglePair> pairs(std::span<const mesh::Triangle> cloth,
                                  std::span<const Vec3d> positions) const;
  /// The same without the tree, for tests of it.
  std::vector<TrianglePair> pairs_by_brute_force(std::span<const mesh::Triangle> cloth,
                                                 std::span<const Vec3d> positions) const;

 private:
  std::vector<TrianglePoints> points_;
  std::vector<Box> boxes_;
  BoxTree tree_;
};

}  // namespace weft::reference
