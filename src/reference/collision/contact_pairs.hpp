// The pairs of cloth and object triangles that intersect, for whole frames.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reference/collision/crossing.hpp"
#include "reference/collision/pairs.hpp"

namespace weft::reference {

/// The triangles of an object, and a tree of boxes over them: the halves of a range of triangles, cut at the
/// middle along the longest side, down to four.
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
  /// Nodes stand in the order of a walk from the left: what does not overlap a node's box is passed by going
  /// on at `after`.
  struct Node {
    Box box;
    std::uint32_t after = 0;             // the next node that is not below this one
    std::uint32_t first = 0, count = 0;  // of a leaf: triangles in order_; count is 0 where there are halves
  };

  void build(std::uint32_t first, std::uint32_t count);

  std::vector<TrianglePoints> points_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace weft::reference
