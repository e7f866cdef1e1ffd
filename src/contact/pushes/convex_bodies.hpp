// The bodies of convex colliders as the kernels read them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::contact {

/// Mirror of ConvexBody in src/contact/pushes/gjk.wgsl. Numbers of points are those within the body.
struct ConvexBody {
  Vec4f low, high;                            // its box [m]
  std::uint32_t first_point = 0, points = 0;  // in `places`
  std::uint32_t first_face = 0, faces = 0;    // in `places`
  std::uint32_t first_edge = 0, edges = 0;    // in `words`, kEdgeWords each
  std::uint32_t first_ring = 0;               // in `words`
  std::uint32_t first_corner = 0;             // in `words`, three a face
};
static_assert(sizeof(ConvexBody) == 64);

inline constexpr std::uint32_t kEdgeWords = 4;

struct ConvexBodies {
  std::vector<ConvexBody> bodies;
  /// Of each body its points [m], then its faces: the outward unit normal, rounded from double, and as w the number of
  /// a corner.
  std::vector<Vec4f> places;
  /// Of each body its edges (two points, the face on the left, the one on the right), then the corners of its faces,
  /// then its rings: for each point and one more where its neighbours begin, from the first ring, then the neighbours.
  std::vector<std::uint32_t> words;
};

/// `hulls` are closed and convex and face outward, as mesh::convex_hull makes them.
/// Errors  Input: an edge has not two faces, or a triangle no area. Limit: a hull has more than mesh::kMostHullVertices
///         corners.
Result<ConvexBodies> convex_bodies(std::span<const mesh::TriangleMesh> hulls);

}  // namespace weft::contact
