#include "contact/reference/proximity/untangle.hpp"

#include <algorithm>
#include <cmath>

#include "contact/reference/proximity/audit.hpp"
#include "contact/reference/proximity/closest.hpp"
#include "contact/rules/contact_law.hpp"
#include "mesh/sheet_rim.hpp"

namespace weft::reference {
namespace {

struct Sheet {
  Vec3d normal, inward;
  double rim = 0;
  SurfaceKind kind = SurfaceKind::Cloth;
};

Vec3d unit(const Vec3d& v) {
  const double size = length(v);
  return size > 0 ? v / size : Vec3d{};
}

Sheet sheet_of(const CrossingFace& face, const std::array<double, 3>& at) {
  const auto& [a, b, c] = face.corners;
  const Vec3d n = unit(cross(b - a, c - a));
  const Vec3d gradient =
      (face.rims[1] - face.rims[0]) * cross(c - a, n) + (face.rims[2] - face.rims[0]) * cross(n, b - a);
  double rim = 0;
  for (std::size_t k = 0; k < 3; ++k) rim += at[k] * face.rims[k];
  return {n, unit(gradient), rim, face.kind};
}

Vec3d contour_from_edge(const Vec3d& p, const Vec3d& e, const Vec3d& tip, const Vec3d& plane) {
  const Vec3d arm = tip - p, across = arm - dot(arm, e) * e;
  const Vec3d line = unit(cross(cross(e, across), plane));
  return dot(line, across) > 0 ? line : -line;
}

/// Equation (7a).
double contour_pull(const Vec3d& e, const Vec3d& turn, const Vec3d& normal) {
  const double slope = dot(e, normal);
  const double steep = slope > 0 ? std::max(slope, kLeastSlope) : std::min(slope, -kLeastSlope);
  return std::clamp(-2 * kContourGain * dot(e, turn) / steep, -1.0, 1.0);
}

/// Equation (7b).
Vec3d rim_pull(const Sheet& own, const Sheet& other) {
  const double slope = dot(own.inward, other.normal);
  return (slope > 0 ? 1.0 : slope < 0 ? -1.0 : 0.0) * other.normal;
}
double rim_way(const Sheet& own, const Sheet& other) {
  return own.rim / std::max(std::abs(dot(own.inward, other.normal)), kLeastSlope);
}

/// Equation (7c).
Vec3d outward(const Sheet& cloth, const Sheet& body) {
  const double slope = dot(cloth.normal, body.normal);
  if (std::abs(slope) > kLeastOutward)
    return (slope > 0 ? 1.0 : -1.0) * cloth.normal + kOutwardPart * body.normal;
  if (dot(cloth.inward, body.normal) > 0) return body.normal;
  return -rim_pull(body, cloth);
}

CrossingFace crossing_face(const TangledSurfaces& of, const mesh::Triangle& t) {
  CrossingFace face;
  for (std::size_t k = 0; k < 3; ++k) {
    face.corners[k] = of.features.positions[t[k]];
    face.rims[k] = of.facts.rims[t[k]];
  }
  face.kind = of.facts.kinds[t[0]];
  return face;
}

/// Whether some features of an edge and a triangle of one cloth do not meet, since they touch at rest: nothing keeps
/// these apart, so that they cross is no tangle.
bool touch_at_rest(const SurfaceFacts& facts, std::uint32_t p, std::uint32_t q, const mesh::Triangle& t) {
  if (facts.bodies[p] != facts.bodies[t[0]]) return false;
  const Vec3d &from = facts.rest[p], &to = facts.rest[q];
  const std::array<Vec3d, 3> at{facts.rest[t[0]], facts.rest[t[1]], facts.rest[t[2]]};
  double least = std::min(closest_on_triangle(from, at[0], at[1], at[2]).distance,
                          closest_on_triangle(to, at[0], at[1], at[2]).distance);
  for (std::size_t k = 0; k < 3; ++k)
    least = std::min(least, closest_segments(from, to, at[k], at[(k + 1) % 3]).distance);
  return least <= facts.touching;
}

/// Finds the edges of one list of triangles that pass through another's, each by its first triangle.
class CrossingFinder {
 public:
  CrossingFinder(const TangledSurfaces& edges, const TangledSurfaces& faces, Tangle& found)
      : edges_(edges), faces_(faces), one_(&edges == &faces), found_(found) {}

  void find() const {
    std::vector<bool> seen(edges_.features.edges.size());
    std::vector<Box> boxes;
    for (const mesh::Triangle& t : faces_.features.triangles)
      boxes.push_back(box_of(faces_.features.positions, t));
    const BoxTree tree(boxes);
    const auto& edges = edges_.features.edges;
    const std::size_t edge_count = edges.size();
    for (std::uint32_t t = 0; t < edges_.features.triangles.size(); ++t)
      for (std::size_t side = 0; side < 3; ++side) {
        const mesh::Triangle& own = edges_.features.triangles[t];
        const std::uint32_t p = own[side], q = own[(side + 1) % 3];
        const mesh::Edge edge{std::min(p, q), std::max(p, q)};
        // A capsule's axis comes after the sorted edges of triangles, and is never looked up.
        const auto at = static_cast<std::size_t>(
            std::lower_bound(edges.begin(), edges.begin() + std::ptrdiff_t(sorted_edges()), edge) -
            edges.begin());
        if (at >= edge_count || seen[at]) continue;
        seen[at] = true;
        const Box box = box_of(edges_.features.positions, edge);
        if (!finite(box)) continue;
        tree.overlapping(box, [&](std::uint32_t face) { meet(t, side, face); });
      }
  }

 private:
  std::size_t sorted_edges() const {
    const auto& edges = edges_.features.edges;
    return static_cast<std::size_t>(std::is_sorted_until(edges.begin(), edges.end()) - edges.begin());
  }
  void meet(std::uint32_t t, std::size_t side, std::uint32_t face) const {
    const mesh::Triangle& own = edges_.features.triangles[t];
    const mesh::Triangle& other = faces_.features.triangles[face];
    const std::uint32_t p = own[side], q = own[(side + 1) % 3];
    if (one_ && std::any_of(other.begin(), other.end(), [&](std::uint32_t v) { return v == p || v == q; }))
      return;
    const CrossingFace crossed = crossing_face(faces_, other);
    const Vec3d &from = edges_.features.positions[p], &to = edges_.features.positions[q];
    if (!segment_crosses(from, to, crossed.corners[0], crossed.corners[1], crossed.corners[2])) return;
    if (one_ && touch_at_rest(edges_.facts, p, q, other)) return;
    ++found_.crossings;
    const bool cloth_edge = edges_.facts.kinds[p] == SurfaceKind::Cloth,
               cloth_face = crossed.kind == SurfaceKind::Cloth;
    std::optional<Vec3d> opposite;
    if (cloth_edge && edges_.facts.opposites[t][side] != kNoCorner)
      opposite = edges_.features.positions[edges_.facts.opposites[t][side]];
    const Vec3d way = way_apart(crossing_face(edges_, own), side, opposite, crossed);
    const auto [b0, b1, b2] = crossing_place(from, to, crossed.corners);
    const PairKind kind = !cloth_edge  ? PairKind::ObjectVertexTriangle
                          : cloth_face ? PairKind::VertexTriangle
                                       : PairKind::VertexObjectTriangle;
    for (const std::uint32_t end : {p, q}) {
      found_.pairs.push_back({kind, end, face, -length(way), unit(way), {1, 0, 0}, {-b0, -b1, -b2}, true});
      if (!cloth_edge) break;  // the obstacle does not feel it
    }
    std::vector<bool>& marks = cloth_edge && cloth_face ? found_.with_cloth : found_.with_mesh;
    if (cloth_edge) marks[p] = marks[q] = true;
    if (cloth_face)
      for (const std::uint32_t v : other) marks[v] = true;
  }

  const TangledSurfaces &edges_, &faces_;
  bool one_;
  Tangle& found_;
};

}  // namespace

std::array<double, 3> crossing_place(const Vec3d& p, const Vec3d& q, const std::array<Vec3d, 3>& corners) {
  const Vec3d d = q - p, a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
  const double ab = dot(d, cross(a, b)), bc = dot(d, cross(b, c)), ca = dot(d, cross(c, a));
  const double sum = ab + bc + ca;
  if (sum == 0) return {1, 0, 0};
  return {bc / sum, ca / sum, ab / sum};
}

Vec3d way_apart(const CrossingFace& edge, std::size_t side, const std::optional<Vec3d>& opposite,
                const CrossingFace& face) {
  const Vec3d &p = edge.corners[side], &q = edge.corners[(side + 1) % 3];
  const std::array<double, 3> at = crossing_place(p, q, face.corners);
  Vec3d through;
  for (std::size_t k = 0; k < 3; ++k) through += at[k] * face.corners[k];
  const double s = closest_on_segment(through, p, q).t;
  std::array<double, 3> on_edge{};
  on_edge[side] = 1 - s;
  on_edge[(side + 1) % 3] = s;
  const Sheet own = sheet_of(edge, on_edge), other = sheet_of(face, at);
  Vec3d way;
  if (other.kind == SurfaceKind::ClosedMesh) {
    way = outward(own, other);
  } else if (own.kind == SurfaceKind::ClosedMesh) {
    way = -outward(other, own);
  } else {
    const Vec3d e = unit(q - p);
    Vec3d turn;
    if (own.kind == SurfaceKind::Cloth) {
      turn = contour_from_edge(p, e, edge.corners[(side + 2) % 3], other.normal);
      if (opposite) turn += contour_from_edge(p, e, *opposite, other.normal);
    }
    way = contour_pull(e, turn, other.normal) * other.normal;
    if (rim_way(own, other) <= rim_way(other, own))
      way += kRimPart * rim_pull(own, other);
    else
      way -= kRimPart * rim_pull(other, own);
  }
  return way / std::max(1.0, length(way));
}

Tangle find_tangle(const TangledSurfaces& cloth, const TangledSurfaces& object, bool self) {
  Tangle found;
  found.with_cloth.resize(cloth.features.positions.size());
  found.with_mesh.resize(cloth.features.positions.size());
  if (self) CrossingFinder(cloth, cloth, found).find();
  CrossingFinder(cloth, object, found).find();
  CrossingFinder(object, cloth, found).find();
  return found;
}

std::vector<bool> release(const Tangle& tangle, const TangledSurfaces& cloth, const TangledSurfaces& object,
                          double thickness, std::span<FeaturePair> pairs) {
  std::vector<bool> released(pairs.size());
  const auto any = [](const std::vector<bool>& marks, const auto& vertices) {
    return std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return marks[v]; });
  };
  const auto radius = [&](const FeaturePair& pair) {
    return pair.kind == PairKind::ObjectVertexTriangle ? object.features.radius_of_vertex(pair.a)
                                                       : object.features.radius_of_edge(pair.b);
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    FeaturePair& pair = pairs[i];
    const std::array<std::uint32_t, 1> vertex{pair.a};
    bool tangled = false, closed = false;
    switch (pair.kind) {
      case PairKind::VertexTriangle:
        tangled = any(tangle.with_cloth, vertex) && any(tangle.with_cloth, cloth.features.triangles[pair.b]);
        break;
      case PairKind::EdgeEdge:
        tangled = any(tangle.with_cloth, cloth.features.edges[pair.a]) &&
                  any(tangle.with_cloth, cloth.features.edges[pair.b]);
        break;
      case PairKind::VertexObjectTriangle:
        tangled = any(tangle.with_mesh, vertex);
        closed = object.facts.kinds[object.features.triangles[pair.b][0]] == SurfaceKind::ClosedMesh;
        break;
      case PairKind::ObjectVertexTriangle:
        tangled = radius(pair) == 0 && any(tangle.with_mesh, cloth.features.triangles[pair.b]);
        closed = radius(pair) == 0 && object.facts.kinds[pair.a] == SurfaceKind::ClosedMesh;
        break;
      case PairKind::EdgeObjectEdge:
        tangled = radius(pair) == 0 && any(tangle.with_mesh, cloth.features.edges[pair.a]);
        closed = radius(pair) == 0 &&
                 object.facts.kinds[object.features.edges[pair.b][0]] == SurfaceKind::ClosedMesh;
        break;
      case PairKind::VertexBall:
      case PairKind::VertexCapsule:
      case PairKind::VertexPlane:
        continue;
    }
    const bool touches = closed && pair.distance < kTouch * thickness;
    if (!touches && !tangled) continue;
    if (pair.kind == PairKind::VertexObjectTriangle && closed) {
      const auto& [a, b, c] = object.features.triangles[pair.b];
      const auto& x = object.features.positions;
      const Vec3d normal = unit(cross(x[b] - x[a], x[c] - x[a]));
      if (length(normal) > 0 && touches) {  // equation (1c)
        pair.inside = pair.in_cones = true;
        pair.direction = normal;
        pair.distance = dot(normal, cloth.features.positions[pair.a] - x[a]);
        continue;
      }
      const bool outside = dot(pair.direction, normal) >= 0;
      if (outside) continue;
      const bool over = pair.weights_b[0] < 0 && pair.weights_b[1] < 0 && pair.weights_b[2] < 0;
      if (length(normal) > 0 && over) {
        pair.inside = pair.distance < thickness;
        pair.in_cones = true;
        pair.distance = -1;
        pair.direction = normal;
        released[i] = true;
        continue;
      }
    }
    pair.inside = false;
    pair.distance = 0;
  }
  return released;
}

}  // namespace weft::reference
