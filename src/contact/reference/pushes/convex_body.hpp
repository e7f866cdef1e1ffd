// A triangle and a convex body in double, by all pairs of features: the oracle of GJK, and independent of it.
#pragma once

#include <array>
#include <vector>

#include "contact/reference/pushes/segment_triangle.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::reference {

/// The hull of a convex collider.
struct ConvexBody {
  std::vector<Vec3d> points;          // [m]
  std::vector<mesh::Triangle> faces;  // outward
  std::vector<Vec3d> normals;         // of the faces, unit
  std::vector<mesh::Edge> edges;      // of the faces
  mesh::Adjacency beside;             // point -> the points at the other ends of its edges
  Vec3d low, high;                    // its box [m]

  /// `hull` is closed and convex and faces outward, as mesh::convex_hull makes them.
  explicit ConvexBody(const mesh::TriangleMesh& hull);
};

/// Where a triangle is nearest to a convex body, or deepest in it.
struct ConvexContact {
  std::array<double, 3> weights{};  // barycentric, of the triangle's point p
  Vec3d point;                      // q, the body's [m]
  Vec3d normal;                     // unit, out of the body; p - q = distance * normal
  double distance = 0;  // [m]; negative where they overlap: the shortest way that takes them apart
};

/// The largest coordinate difference of a corner of the triangle and a point of the body [m]: what errors are measured
/// by.
double pair_size(const TrianglePoints& triangle, const ConvexBody& body);

/// How far the directions of all faces, and of all pairs of edges, tell a triangle and a body apart.
struct Separation {
  Vec3d axis;           // the best of them: unit, out of the body
  double distance = 0;  // along it [m]; positive: they are apart. Negative: minus the least depth
};
/// Gottschalk, Lin and Manocha 1996: where no such direction has a positive distance, none has. `to_know_sign`: ends
/// with the first positive one.
Separation separation(const TrianglePoints& triangle, const ConvexBody& body, bool to_know_sign = false);

/// By brute force: corners against faces, points against the triangle, edges against edges. Of an overlapping pair the
/// direction is that of `separation`, and the points are those of the triangle moved out along it.
ConvexContact contact_by_features(const TrianglePoints& triangle, const ConvexBody& body);

}  // namespace weft::reference
