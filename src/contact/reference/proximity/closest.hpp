// Closest points of the features that touch: vertex and triangle, edge and edge, vertex and plane, in double.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.hpp"
#include "mesh/closest.hpp"

namespace weft::reference {

using mesh::closest_on_segment;
using mesh::closest_on_triangle;
using mesh::ClosestOnSegment;
using mesh::ClosestOnTriangle;

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

/// From the closest point of side B to that of side A [m]: `at` has the corners of A, then of B, of two vertices, a
/// vertex and a triangle, or two edges.
Vec3d offset_between(std::uint32_t count_a, std::uint32_t count_b, const std::array<Vec3d, 4>& at);

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
