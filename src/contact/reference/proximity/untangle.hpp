// Cloth that begins in a tangle: what passes through what, and which way both have to go to come apart, in
// double. Equations (7) of docs/contact.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/reference/proximity/pairs.hpp"

namespace weft::reference {

enum class SurfaceKind : std::uint8_t { Cloth, OpenMesh, ClosedMesh };

/// A triangle of a crossing.
struct CrossingFace {
  std::array<Vec3d, 3> corners;  // [m]
  std::array<double, 3> rims{};  // distance of each corner from its sheet's rim [m]
  SurfaceKind kind = SurfaceKind::Cloth;
};

/// Where a segment that crosses a triangle passes through it, as weights of the corners.
std::array<double, 3> crossing_place(const Vec3d& p, const Vec3d& q, const std::array<Vec3d, 3>& corners);

/// How an edge has to move against the triangle that it passes through, in parts of the speed, at most 1. The
/// edge goes from corner `side` of its triangle to the next; `opposite` is the corner across it, where there
/// is another triangle.
Vec3d way_apart(const CrossingFace& edge, std::size_t side, const std::optional<Vec3d>& opposite,
                const CrossingFace& face);

/// Data of the cloth, or of all obstacles, that untangling needs besides their features.
struct SurfaceFacts {
  std::vector<double> rims;               // of each position [m]
  std::vector<SurfaceKind> kinds;         // of each position
  std::vector<mesh::Triangle> opposites;  // of each triangle, of cloth
  std::vector<Vec3d> rest;                // of cloth, each position at rest [m]
  std::vector<std::uint32_t> bodies;      // of cloth, whose each position is
  double touching = 0;                    // features of one cloth no further apart at rest do not meet [m]
};
struct TangledSurfaces {
  const Features& features;
  const SurfaceFacts& facts;
};

struct Tangle {
  std::size_t crossings = 0;  // edges through triangles that they do not touch at rest
  std::vector<FeaturePair>
      pairs;  // ends of such edges and the triangles; distance: minus the part of the speed
  std::vector<bool> with_cloth,
      with_mesh;  // of each cloth vertex: it belongs to a crossing of cloth, of a mesh
};
/// All that passes through each other now. `self`: whether cloth meets cloth; then the facts of cloth are all there.
Tangle find_tangle(const TangledSurfaces& cloth, const TangledSurfaces& object, bool self);

/// A feature that is, or may be, on the wrong side of its pair does not act; a vertex inside a closed mesh is sent
/// out: changes the pairs, and marks those that now separate features on the wrong side.
std::vector<bool> release(const Tangle& tangle, const TangledSurfaces& cloth, const TangledSurfaces& object,
                          double thickness, std::span<FeaturePair> pairs);

}  // namespace weft::reference
