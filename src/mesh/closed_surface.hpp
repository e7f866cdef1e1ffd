// What lies inside a closed triangle mesh, and how deep.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Distances and crossings of a closed surface, over a tree of boxes around its triangles.
///
/// A point is inside where a ray along at least two of the three axes crosses the surface an odd number of times. So a
/// hollow is outside whichever way its triangles face, and turned triangles do no harm; where two closed parts overlap,
/// the overlap is outside. A ray through an edge or a vertex counts right, since each edge is asked on which side of it
/// the ray passes, and both its triangles get the same answer: a line's crossings are an even number whatever is
/// rounded. The other two axes outvote one whose crossing is rounded to the wrong side of the point.
class ClosedSurface {
 public:
  /// Errors  Input: check_mesh, or an edge that has other than two triangles, with both its vertices. A triangle that
  ///         names a vertex twice counts as none.
  static Result<ClosedSurface> create(const TriangleMesh& mesh);

  const Bounds& bounds() const { return bounds_; }

  /// The distance to the closest point of the surface [m].
  double distance(const Vec3d& point) const;

  /// Where the line through a point along an axis crosses the surface, coordinates on that axis in rising order [m].
  void crossings(int axis, const Vec3d& point, std::vector<double>& found) const;

  /// The distance, negative outside [m].
  double depth(const Vec3d& point) const;

 private:
  struct Node {
    Vec3f low, high;          // m
    std::uint32_t first = 0;  // child, of which the second follows; or triangle, of `count`
    std::uint32_t count = 0;  // 0: it has children
  };
  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<Vec3f> positions_;  // m
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  Bounds bounds_;
};

}  // namespace weft::mesh
