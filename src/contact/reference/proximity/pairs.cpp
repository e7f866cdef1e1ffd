#include "contact/reference/proximity/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/reference/proximity/audit.hpp"
#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/proximity/cones.hpp"
#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

Box grown(const Box& box, double by) { return {box.low - Vec3d{by, by, by}, box.high + Vec3d{by, by, by}}; }

Box box_of_vertex(const Features& of, std::uint32_t vertex) {
  return grown({of.positions[vertex], of.positions[vertex]}, of.radius_of_vertex(vertex));
}
Box box_of_edge(const Features& of, std::uint32_t edge) {
  return grown(box_of(of.positions, of.edges[edge]), of.radius_of_edge(edge));
}
Box box_of_triangle(const Features& of, std::uint32_t triangle) {
  return box_of(of.positions, of.triangles[triangle]);
}

bool names(const auto& feature, std::uint32_t vertex) {
  return std::find(feature.begin(), feature.end(), vertex) != feature.end();
}

/// Whether features with these corners are in each other, but for rounding (kNoDistance).
bool is_in_place(const FeaturePair& pair, const std::array<Vec3d, 4>& corners) {
  double farthest = 0;
  for (const Vec3d& x : corners) farthest = std::max({farthest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  return pair.distance <= kNoDistance * farthest;
}

/// Of the triangles at a vertex together, and of one; not normalised.
Vec3d front_of(const Features& of, std::uint32_t triangle) {
  const auto& [a, b, c] = of.triangles[triangle];
  return cross(of.positions[b] - of.positions[a], of.positions[c] - of.positions[a]);
}
Vec3d front_at(const Features& of, std::uint32_t vertex) {
  Vec3d sum;
  if (vertex >= of.triangles_at.row_count()) return sum;
  for (const std::uint32_t t : of.triangles_at.row(vertex)) sum += front_of(of, t);
  return sum;
}

/// Equation (1b): whether a vertex comes out on the front of a triangle that it is in.
bool comes_on_front(PairKind kind, const Features& cloth, std::uint32_t vertex, const mesh::Triangle& face,
                    bool opposite) {
  if (kind == PairKind::VertexObjectTriangle) return true;
  if (kind == PairKind::ObjectVertexTriangle) return opposite;
  const std::uint32_t own = cloth.cloths.empty() ? 0 : cloth.cloths[vertex];
  const std::uint32_t other = cloth.cloths.empty() ? 0 : cloth.cloths[face[0]];
  if (((own ^ other) & kHasInside) != 0) return (other & kHasInside) != 0 || opposite;
  return opposite ? own != other : vertex > face[0];
}

FeaturePair vertex_triangle(PairKind kind, const Features& first, std::uint32_t vertex,
                            const Features& second, std::uint32_t triangle) {
  const mesh::Triangle& face = second.triangles[triangle];
  const auto& x = second.positions;
  const ClosestOnTriangle closest =
      closest_on_triangle(first.positions[vertex], x[face[0]], x[face[1]], x[face[2]]);
  const double radius = first.radius_of_vertex(vertex);
  const Gap gap = gap_of(closest.offset, radius);
  const auto [b0, b1, b2] = closest.weights;
  FeaturePair pair{kind, vertex, triangle, gap.distance, gap.direction, {1, 0, 0}, {-b0, -b1, -b2}, true};
  if (radius > 0) {
    const auto to = [&](std::uint32_t corner) { return length(first.positions[vertex] - x[corner]); };
    const double ends = std::min({to(face[0]), to(face[1]), to(face[2])});
    pair.distance += spare_of(ends - length(closest.offset), first.most_spare);
    pair.inside = std::max({b0, b1, b2}) < 1;
    return pair;
  }
  if (!is_in_place(pair, {first.positions[vertex], x[face[0]], x[face[1]], x[face[2]]})) return pair;
  const Vec3d across = front_of(second, triangle);
  const double size = length(across);
  const bool on_front = comes_on_front(kind, first, vertex, face, dot(front_at(first, vertex), across) < 0);
  pair.distance = 0;
  pair.inside = size > 0;
  if (pair.inside) pair.direction = (on_front ? 1 : -1) * (across / size);
  return pair;
}

FeaturePair edge_edge(PairKind kind, const Features& first, std::uint32_t of_first, const Features& second,
                      std::uint32_t of_second) {
  const mesh::Edge &a = first.edges[of_first], &b = second.edges[of_second];
  const ClosestSegments closest = closest_segments(first.positions[a[0]], first.positions[a[1]],
                                                   second.positions[b[0]], second.positions[b[1]]);
  const double radius = first.radius_of_edge(of_first) + second.radius_of_edge(of_second);
  const Gap gap = gap_of(closest.offset, radius);
  FeaturePair pair{kind,
                   of_first,
                   of_second,
                   gap.distance,
                   gap.direction,
                   {1 - closest.s, closest.s, 0},
                   {closest.t - 1, -closest.t, 0},
                   closest.inside_first() && closest.inside_second()};
  if (radius > 0) {
    const Vec3d &c = second.positions[b[0]], &d = second.positions[b[1]];
    const double ends = std::min(closest_on_segment(first.positions[a[0]], c, d).distance,
                                 closest_on_segment(first.positions[a[1]], c, d).distance);
    pair.distance += spare_of(ends - length(closest.offset), second.most_spare);
    pair.inside = closest.inside_first();
    return pair;
  }
  if (!is_in_place(pair, {first.positions[a[0]], first.positions[a[1]], second.positions[b[0]],
                          second.positions[b[1]]}))
    return pair;
  pair.distance = 0;
  pair.inside = false;
  return pair;
}

/// Of a vertex of cloth and the axis of a round obstacle from one position to another.
FeaturePair vertex_round(PairKind kind, const Features& cloth, std::uint32_t vertex, const Features& object,
                         std::uint32_t number) {
  const bool capsule = kind == PairKind::VertexCapsule;
  const mesh::Edge axis = capsule ? object.edges[number] : mesh::Edge{number, number};
  const ClosestOnSegment closest =
      closest_on_segment(cloth.positions[vertex], object.positions[axis[0]], object.positions[axis[1]]);
  const Gap gap = gap_of(closest.offset, object.radius_of_vertex(axis[0]));
  const std::array<double, 3> weights{closest.t - 1, -closest.t, 0};
  return {kind, vertex, number, gap.distance, gap.direction, {1, 0, 0}, weights, true};
}

/// Collects the pairs of two lists of features; those of one list must not share a vertex.
class Finder {
 public:
  Finder(const Features& first, const Features& second, double reach, std::vector<FeaturePair>& found)
      : first_(first), second_(second), one_(&first == &second), reach_(reach), found_(found) {}

  void vertex_triangle(PairKind kind, std::uint32_t vertex, std::uint32_t triangle) {
    if (one_ && names(second_.triangles[triangle], vertex)) return;
    add(reference::vertex_triangle(kind, first_, vertex, second_, triangle));
  }
  void vertex_round(PairKind kind, std::uint32_t vertex, std::uint32_t number) {
    add(reference::vertex_round(kind, first_, vertex, second_, number));
  }
  void vertex_rounds(std::uint32_t vertex) {
    for (const std::uint32_t ball : second_.balls) vertex_round(PairKind::VertexBall, vertex, ball);
    for (const std::uint32_t capsule : second_.capsules)
      vertex_round(PairKind::VertexCapsule, vertex, capsule);
  }
  void edges(PairKind kind, std::uint32_t of_first, std::uint32_t of_second) {
    const mesh::Edge &a = first_.edges[of_first], &b = second_.edges[of_second];
    if (one_ && (names(b, a[0]) || names(b, a[1]))) return;
    add(edge_edge(kind, first_, of_first, second_, of_second));
  }

 private:
  void add(const FeaturePair& pair) {
    if (pair.distance < reach_) found_.push_back(pair);
  }

  const Features &first_, &second_;
  bool one_;
  double reach_;
  std::vector<FeaturePair>& found_;
};

/// Boxes are searched a little further than pairs may be: their distance is rounded too.
double search_radius(double reach) { return reach * (1 + 1e-9); }

}  // namespace

void Features::add_capsule(const Vec3d& a, const Vec3d& b, double radius) {
  const std::uint32_t first = add_round_vertex(a, radius), second = add_round_vertex(b, radius);
  edge_radius.resize(edges.size(), 0);
  capsules.push_back(static_cast<std::uint32_t>(edges.size()));
  edges.push_back({first, second});
  edge_radius.push_back(radius);
}

void Features::add_sphere(const Vec3d& center, double radius) {
  balls.push_back(add_round_vertex(center, radius));
}

std::uint32_t Features::add_round_vertex(const Vec3d& center, double radius) {
  const auto number = static_cast<std::uint32_t>(positions.size());
  vertex_radius.resize(number, 0);
  vertices.push_back(number);
  positions.push_back(center);
  vertex_radius.push_back(radius);
  return number;
}

double spare_of(double more, double most) { return std::min(more, std::max(0.0, 2 * most - more)); }

Features features_of(std::vector<Vec3d> positions, std::vector<mesh::Triangle> triangles) {
  Features features;
  features.positions = std::move(positions);
  features.triangles = std::move(triangles);
  features.edges = mesh::mesh_edges(features.triangles);
  features.triangles_at = mesh::triangle_adjacency(features.positions.size(), features.triangles);
  std::vector<bool> used(features.positions.size());
  for (const mesh::Triangle& triangle : features.triangles)
    for (const std::uint32_t vertex : triangle) used[vertex] = true;
  for (std::uint32_t vertex = 0; vertex < used.size(); ++vertex)
    if (used[vertex]) features.vertices.push_back(vertex);
  return features;
}

bool operator<(const FeaturePair& x, const FeaturePair& y) {
  return std::tie(x.kind, x.a, x.b) < std::tie(y.kind, y.a, y.b);
}
bool same_features(const FeaturePair& x, const FeaturePair& y) {
  return std::tie(x.kind, x.a, x.b) == std::tie(y.kind, y.a, y.b);
}

FeaturePair measured(const FeaturePair& pair, const Features& cloth, const Features& object) {
  FeaturePair now = pair;
  switch (pair.kind) {
    case PairKind::VertexTriangle:
      now = vertex_triangle(pair.kind, cloth, pair.a, cloth, pair.b);
      break;
    case PairKind::EdgeEdge:
      now = edge_edge(pair.kind, cloth, pair.a, cloth, pair.b);
      break;
    case PairKind::VertexObjectTriangle:
      now = vertex_triangle(pair.kind, cloth, pair.a, object, pair.b);
      break;
    case PairKind::ObjectVertexTriangle:
      now = vertex_triangle(pair.kind, object, pair.a, cloth, pair.b);
      break;
    case PairKind::EdgeObjectEdge:
      now = edge_edge(pair.kind, cloth, pair.a, object, pair.b);
      break;
    case PairKind::VertexBall:
    case PairKind::VertexCapsule:
      now = vertex_round(pair.kind, cloth, pair.a, object, pair.b);
      break;
    case PairKind::VertexPlane:
      break;
  }
  now.in_cones = in_cones(now, cloth, object);
  return now;
}

FeatureTrees trees_of(const Features& features) {
  std::vector<Box> vertices, edges, triangles;
  for (const std::uint32_t vertex : features.vertices) vertices.push_back(box_of_vertex(features, vertex));
  for (std::uint32_t e = 0; e < features.edges.size(); ++e) edges.push_back(box_of_edge(features, e));
  for (std::uint32_t t = 0; t < features.triangles.size(); ++t)
    triangles.push_back(box_of_triangle(features, t));
  return {BoxTree(vertices), BoxTree(edges), BoxTree(triangles)};
}

std::vector<FeaturePair> self_pairs(const Features& cloth, double reach) {
  const FeatureTrees trees = trees_of(cloth);
  const double radius = search_radius(reach);
  std::vector<FeaturePair> found;
  Finder finder(cloth, cloth, reach, found);
  for (const std::uint32_t v : cloth.vertices) {
    const Box box = box_of_vertex(cloth, v);
    if (!finite(box)) continue;
    trees.triangles.within(box, radius,
                           [&](std::uint32_t t) { finder.vertex_triangle(PairKind::VertexTriangle, v, t); });
  }
  for (std::uint32_t e = 0; e < cloth.edges.size(); ++e) {
    const Box box = box_of_edge(cloth, e);
    if (!finite(box)) continue;
    trees.edges.within(box, radius, [&](std::uint32_t other) {
      if (e < other) finder.edges(PairKind::EdgeEdge, e, other);
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<FeaturePair> object_pairs(const Features& cloth, const Features& object,
                                      const FeatureTrees& trees, double reach) {
  const double radius = search_radius(reach);
  std::vector<FeaturePair> found;
  Finder from_cloth(cloth, object, reach, found), from_object(object, cloth, reach, found);
  for (const std::uint32_t v : cloth.vertices) {
    const Box box = box_of_vertex(cloth, v);
    if (!finite(box)) continue;
    trees.triangles.within(box, radius, [&](std::uint32_t t) {
      from_cloth.vertex_triangle(PairKind::VertexObjectTriangle, v, t);
    });
    from_cloth.vertex_rounds(v);
  }
  for (std::uint32_t t = 0; t < cloth.triangles.size(); ++t) {
    const Box box = box_of_triangle(cloth, t);
    if (!finite(box)) continue;
    trees.vertices.within(box, radius, [&](std::uint32_t place) {
      from_object.vertex_triangle(PairKind::ObjectVertexTriangle, object.vertices[place], t);
    });
  }
  for (std::uint32_t e = 0; e < cloth.edges.size(); ++e) {
    const Box box = box_of_edge(cloth, e);
    if (!finite(box)) continue;
    trees.edges.within(box, radius,
                       [&](std::uint32_t other) { from_cloth.edges(PairKind::EdgeObjectEdge, e, other); });
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<FeaturePair> plane_pairs(const Features& cloth, std::span<const scene::ColliderPlane> planes,
                                     double reach) {
  std::vector<FeaturePair> found;
  for (const std::uint32_t v : cloth.vertices)
    for (std::uint32_t p = 0; p < planes.size(); ++p) {
      const Gap gap = plane_gap(cloth.positions[v], planes[p].point, planes[p].normal);
      if (gap.distance < reach)
        found.push_back({PairKind::VertexPlane, v, p, gap.distance, gap.direction, {1, 0, 0}, {}, true});
    }
  return found;
}

std::vector<FeaturePair> self_pairs_by_brute_force(const Features& cloth, double reach) {
  std::vector<FeaturePair> found;
  Finder finder(cloth, cloth, reach, found);
  for (const std::uint32_t v : cloth.vertices)
    for (std::uint32_t t = 0; t < cloth.triangles.size(); ++t)
      if (finite(box_of_vertex(cloth, v)) && finite(box_of_triangle(cloth, t)))
        finder.vertex_triangle(PairKind::VertexTriangle, v, t);
  for (std::uint32_t e = 0; e < cloth.edges.size(); ++e)
    for (std::uint32_t other = e + 1; other < cloth.edges.size(); ++other)
      if (finite(box_of_edge(cloth, e)) && finite(box_of_edge(cloth, other)))
        finder.edges(PairKind::EdgeEdge, e, other);
  return found;
}

std::vector<FeaturePair> object_pairs_by_brute_force(const Features& cloth, const Features& object,
                                                     double reach) {
  std::vector<FeaturePair> found;
  Finder from_cloth(cloth, object, reach, found), from_object(object, cloth, reach, found);
  for (const std::uint32_t v : cloth.vertices)
    for (std::uint32_t t = 0; t < object.triangles.size(); ++t)
      if (finite(box_of_vertex(cloth, v)) && finite(box_of_triangle(object, t)))
        from_cloth.vertex_triangle(PairKind::VertexObjectTriangle, v, t);
  for (const std::uint32_t v : object.vertices)
    for (std::uint32_t t = 0; t < cloth.triangles.size(); ++t)
      if (finite(box_of_vertex(object, v)) && finite(box_of_triangle(cloth, t)))
        from_object.vertex_triangle(PairKind::ObjectVertexTriangle, v, t);
  for (std::uint32_t e = 0; e < cloth.edges.size(); ++e)
    for (std::uint32_t other = 0; other < object.edges.size(); ++other)
      if (finite(box_of_edge(cloth, e)) && finite(box_of_edge(object, other)))
        from_cloth.edges(PairKind::EdgeObjectEdge, e, other);
  for (const std::uint32_t v : cloth.vertices)
    if (finite(box_of_vertex(cloth, v))) from_cloth.vertex_rounds(v);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace weft::reference
