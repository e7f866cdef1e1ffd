#include "contact/reference/proximity/cones.hpp"

#include <algorithm>

#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

/// Whether `way` does not lead on along `inward`, by more than its rounding.
bool leads_off(const Vec3d& way, const Vec3d& inward) {
  return dot(way, inward) <= kConeSlack * length(way) * length(inward);
}

/// Whether a node is one of these, or beside one.
bool is_beside(const Features& of, std::uint32_t node, std::span<const std::uint32_t> met) {
  const auto is_met = [&](std::uint32_t one) { return std::find(met.begin(), met.end(), one) != met.end(); };
  if (met.empty()) return false;
  if (is_met(node)) return true;
  const auto triangles = of.triangles_at.row(node);
  return std::any_of(triangles.begin(), triangles.end(), [&](std::uint32_t t) {
    return std::any_of(of.triangles[t].begin(), of.triangles[t].end(), is_met);
  });
}

/// The part of the triangle's surface that is nearest to the vertex of a pair.
bool in_cone_of_triangle(const Features& of, const mesh::Triangle& triangle,
                         const std::array<double, 3>& weights, const Vec3d& way,
                         std::span<const std::uint32_t> met) {
  std::vector<std::uint32_t> corners;
  for (std::size_t k = 0; k < 3; ++k)
    if (weights[k] != 0) corners.push_back(triangle[k]);
  if (corners.size() == 3) return true;
  if (corners.size() == 1) return in_cone_of_vertex(of, corners[0], way, met);
  return in_cone_of_edge(of, {corners[0], corners[1]}, way, met);
}

}  // namespace

bool in_cone_of_edge(const Features& of, const mesh::Edge& edge, const Vec3d& way,
                     std::span<const std::uint32_t> met) {
  if (edge[0] >= of.triangles_at.row_count()) return true;  // of a capsule
  const Vec3d& end = of.positions[edge[0]];
  const Vec3d along = of.positions[edge[1]] - end;
  if (!(length(along) > 0)) return true;
  for (const std::uint32_t t : of.triangles_at.row(edge[0])) {
    const mesh::Triangle& corners = of.triangles[t];
    if (std::find(corners.begin(), corners.end(), edge[1]) == corners.end()) continue;
    for (const std::uint32_t corner : corners) {
      if (corner == edge[0] || corner == edge[1] || is_beside(of, corner, met)) continue;
      const Vec3d out = of.positions[corner] - end;
      if (!leads_off(way, out - (dot(out, along) / dot(along, along)) * along)) return false;
    }
  }
  return true;
}

bool in_cone_of_vertex(const Features& of, std::uint32_t vertex, const Vec3d& way,
                       std::span<const std::uint32_t> met) {
  if (vertex >= of.triangles_at.row_count()) return true;  // a sphere, the end of a capsule
  for (const std::uint32_t t : of.triangles_at.row(vertex))
    for (const std::uint32_t corner : of.triangles[t])
      if (!is_beside(of, corner, met) && !leads_off(way, of.positions[corner] - of.positions[vertex]))
        return false;
  return true;
}

bool in_cones(const FeaturePair& pair, const Features& cloth, const Features& object) {
  if (!(pair.distance > 0)) return true;  // it has no direction
  const Vec3d &from_b = pair.direction, from_a = -pair.direction;
  switch (pair.kind) {
    case PairKind::VertexTriangle: {
      const mesh::Triangle& triangle = cloth.triangles[pair.b];
      const bool inside = std::count(pair.weights_b.begin(), pair.weights_b.end(), 0.0) == 0;
      return inside || (in_cone_of_triangle(cloth, triangle, pair.weights_b, from_b, {&pair.a, 1}) &&
                        in_cone_of_vertex(cloth, pair.a, from_a, triangle));
    }
    case PairKind::VertexObjectTriangle:
      return in_cone_of_triangle(object, object.triangles[pair.b], pair.weights_b, from_b, {});
    case PairKind::ObjectVertexTriangle:
      return object.radius_of_vertex(pair.a) > 0 ||
             (in_cone_of_triangle(cloth, cloth.triangles[pair.b], pair.weights_b, from_b, {}) &&
              in_cone_of_vertex(object, pair.a, from_a));
    case PairKind::EdgeEdge:
      return in_cone_of_edge(cloth, cloth.edges[pair.a], from_a, cloth.edges[pair.b]) &&
             in_cone_of_edge(cloth, cloth.edges[pair.b], from_b, cloth.edges[pair.a]);
    case PairKind::EdgeObjectEdge:
      return object.radius_of_edge(pair.b) > 0 || (in_cone_of_edge(cloth, cloth.edges[pair.a], from_a) &&
                                                   in_cone_of_edge(object, object.edges[pair.b], from_b));
    case PairKind::VertexBall:
    case PairKind::VertexCapsule:
    case PairKind::VertexPlane:
      return true;
  }
  return true;
}

}  // namespace weft::reference
