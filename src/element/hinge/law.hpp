// The angle at an edge between two triangles. In double. Source: docs/elements.md, Bending.
//
//        c
//       / \         first triangle a b c, second b a d, both counter-clockwise seen from the side to which normals
//      a---b        point. The angle is 0 where they lie in a plane, positive where c and d are on that side of it.
//       \ /
//        d
#pragma once

#include <array>
#include <cmath>

#include "base/vec.hpp"

namespace weft::hinge {

using Corners = std::array<Vec3d, 4>;  // a, b, c, d

/// In (-pi, pi] [rad].
inline double angle(const Corners& x) {
  const auto& [a, b, c, d] = x;
  const Vec3d edge = b - a, first = cross(edge, c - a), second = cross(d - a, edge);
  return std::atan2(dot(cross(second, first), edge), length(edge) * dot(first, second));
}

/// How much of a rise of c, or of d, leaves the edge by its heights over the edge: where they stand on it.
struct Feet {
  double c = 0, d = 0;  // from a (0) to b (1)
};
inline Feet feet(const Corners& x) {
  const auto& [a, b, c, d] = x;
  const Vec3d edge = b - a;
  return {dot(c - a, edge) / dot(edge, edge), dot(d - a, edge) / dot(edge, edge)};
}

/// By the corners [1/m]: c and d each move across their triangle at 1 / height, and the edge's ends take the rest.
/// Source: Bridson et al. 2003, section 3.
inline Corners angle_slope(const Corners& x) {
  const auto& [a, b, c, d] = x;
  const Vec3d edge = b - a, first = cross(edge, c - a), second = cross(d - a, edge);
  const double span = length(edge);
  const Vec3d at_c = span / dot(first, first) * first, at_d = span / dot(second, second) * second;
  const Feet foot = feet(x);
  return {(foot.c - 1) * at_c + (foot.d - 1) * at_d, -foot.c * at_c - foot.d * at_d, at_c, at_d};
}

/// The same for small angles as a fixed linear form of the corners, whose value on a bent sheet that is not stretched
/// is a vector of length 2 sin(angle / 2). `x` are corners at rest, in a plane.
/// Source: Bergou et al. 2006, "A quadratic bending model for inextensible surfaces", section 4.
inline std::array<double, 4> flat_slope(const Corners& x) {
  const auto& [a, b, c, d] = x;
  const double span = length(b - a);
  const double at_c = span / length(cross(b - a, c - a)), at_d = span / length(cross(b - a, d - a));
  const Feet foot = feet(x);
  return {(foot.c - 1) * at_c + (foot.d - 1) * at_d, -foot.c * at_c - foot.d * at_d, at_c, at_d};
}

}  // namespace weft::hinge
