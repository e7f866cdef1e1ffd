// A triangle mesh as plain data, and what is asked of every one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"

namespace weft::mesh {

using Triangle = std::array<std::uint32_t, 3>;  // vertices, counter-clockwise seen from outside

struct TriangleMesh {
  std::vector<Vec3f> positions;  // m
  std::vector<Triangle> triangles;
};

/// The axis-aligned box around a mesh [m]; all zero for a mesh without vertices.
struct Bounds {
  Vec3f low, high;
};
Bounds bounds(const TriangleMesh& mesh);

/// The volume inside a closed mesh [m³], positive if its triangles face outward.
double signed_volume(const TriangleMesh& mesh);
/// The same of places in double; it is summed from one of them on, so that it is as exact far from the origin.
double signed_volume(std::span<const Triangle> triangles, std::span<const Vec3d> places);

/// Whether a mesh can be used at all. Every reader ends with it.
/// Errors  Input: no triangle, a triangle names a vertex that is not there, a coordinate is not finite, or
///         there are more vertices or triangles than a 32-bit index can name.
Result<void> check_mesh(const TriangleMesh& mesh);

/// Removes the triangles that name a vertex twice or whose corners lie on a line, and returns their number.
/// The cross product is taken in double, where it is zero only if its two products round to the same. `shapes` are the
/// mesh's vertices in other places: a triangle that has an area in one of them stays.
std::size_t drop_degenerate_triangles(TriangleMesh& mesh, std::span<const std::vector<Vec3f>> shapes = {});

/// A rotation as (x, y, z, w); need not be of unit length, must not be zero.
using Quaternion = std::array<double, 4>;

/// The mesh scaled (scale > 0), then rotated, then moved by `translation` [m]. In double, rounded once at the
/// end; a result too large for float is infinite, so check_mesh follows where values come from a user.
TriangleMesh transformed(const TriangleMesh& mesh, double scale, const Quaternion& rotation,
                         const Vec3d& translation);

}  // namespace weft::mesh
