// The smallest convex body that contains given points.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

inline constexpr std::size_t kMostHullVertices = std::size_t{1} << 16U;

/// How far a point may lie outside of its hull [m]: 8 units of the last place of the largest coordinate. Places of f32
/// are themselves rounded by half a unit, so points of a flat face lie up to a unit or so beside it; such bumps are no
/// corners.
double hull_tolerance(std::span<const Vec3f> points);

/// The convex hull as a closed mesh that faces outward: its corners are some of the points, in their order, and it is
/// convex to the bit. Of points in the plane of a face, or on the line of an edge, only the corners remain; a face of
/// more than three corners is divided into triangles.
/// Errors  Input: a coordinate is not finite; the points lie in a plane, on a line or in one place, to hull_tolerance.
///         Limit: more than kMostHullVertices corners.
/// Source  Barber, Dobkin and Huhdanpaa 1996, The Quickhull Algorithm for Convex Hulls, with exact signs instead of
///         wide facets.
Result<TriangleMesh> convex_hull(std::span<const Vec3f> points);

}  // namespace weft::mesh
