// The points of triangles and segments that are closest to a point, in double.
#pragma once

#include <array>

#include "base/vec.hpp"

namespace weft::mesh {

/// The point of a triangle that is closest to a point p.
struct ClosestOnTriangle {
  std::array<double, 3> weights{};  // barycentric: none negative, their sum is 1
  Vec3d offset;                     // from the triangle's point to p [m]
  double distance = 0;              // [m]
};
/// Where the projection of p falls inside, it is that; otherwise the closest point of the nearest edge. A
/// triangle without area has only edges; one whose normal is lost in rounding keeps the better of both, so
/// that the distance is always one to a point of the triangle. Source: Ericson 2005, Real-Time Collision
/// Detection, section 5.1.5.
ClosestOnTriangle closest_on_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// The point of a segment that is closest to a point p; the segment's first end where it has no length.
struct ClosestOnSegment {
  double t = 0;         // the segment's point is a + t (b - a)
  Vec3d offset;         // from the segment's point to p [m]
  double distance = 0;  // [m]
};
ClosestOnSegment closest_on_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b);

}  // namespace weft::mesh
