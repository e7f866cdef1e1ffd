// Closest points of the features that touch: vertex and triangle, edge and edge, vertex and plane, in double.
#pragma once

#include <array>

#include "base/vec.hpp"

namespace weft::reference {

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

/// The closest points of two segments: a0 + s (a1 - a0) and b0 + t (b1 - b0).
struct ClosestSegments {
  double s = 0, t = 0;  // in [0, 1]
  Vec3d offset;         // from the point of the second to that of the first [m]
  double distance = 0;  // [m]

  bool inside_first() const { return s > 0 && s < 1; }
  bool inside_second() const { return t > 0 && t < 1; }
};
/// Both points are inside their segments only where no end is as near: parallel segments have many
/// closest points, and one with an end is taken.
ClosestSegments closest_segments(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0, const Vec3d& b1);

/// How far two surfaces are apart, and along which line.
struct Gap {
  Vec3d direction;      // unit, from B to A; +y where the closest points are one
  double distance = 0;  // less the radius: negative inside a sphere or capsule, or below a plane [m]
};
/// Of closest points p_A and p_B with offset p_A - p_B, of which one is the centre or axis of a body with
/// this radius.
Gap gap_of(const Vec3d& offset, double radius);
/// Of a point from a plane with this unit normal.
Gap plane_gap(const Vec3d& point, const Vec3d& on_plane, const Vec3d& normal);

}  // namespace weft::reference
