#include "mesh/coarse_mesh.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace weft::mesh {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
using NodeLists = std::vector<std::vector<std::uint32_t>>;

/// For each node, the numbers of the edges or triangles that name it.
template <class Item>
NodeLists items_of(std::size_t node_count, const std::vector<Item>& items) {
  NodeLists lists(node_count);
  for (std::uint32_t i = 0; i < items.size(); ++i)
    for (const std::uint32_t node : items[i]) lists[node].push_back(i);
  return lists;
}

/// For each edge, whether it belongs to one triangle only.
std::vector<bool> boundary_edges(const Network& mesh) {
  std::vector<Edge> sides;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({low, high});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<bool> found;
  for (const Edge& edge : mesh.edges) {
    const auto [first, end] = std::equal_range(sides.begin(), sides.end(), edge);
    found.push_back(end - first == 1);
  }
  return found;
}

/// For each node, whether it lies on the boundary: on a rim of the triangles, or where there is volume on its surface.
std::vector<bool> boundary_nodes(const Network& mesh) {
  std::vector<bool> found(mesh.positions.size(), false);
  if (!mesh.tets.empty()) {
    for (const Triangle& t : mesh.triangles)
      for (const std::uint32_t node : t) found[node] = true;
    return found;
  }
  const std::vector<bool> boundary = boundary_edges(mesh);
  for (std::size_t e = 0; e < boundary.size(); ++e)
    if (boundary[e]) found[mesh.edges[e][0]] = found[mesh.edges[e][1]] = true;
  return found;
}

std::vector<std::uint32_t> kept_nodes(const Network& mesh, const NodeLists& edges_of,
                                      const std::vector<bool>& on_boundary) {
  const std::size_t count = mesh.positions.size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  // Those that block most: of a lattice where every other node has few, the few would be half of all.
  if (!mesh.tets.empty())
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return edges_of[a].size() > edges_of[b].size();
    });
  std::vector<bool> kept(count, false), blocked(count, false);
  for (const bool first : {true, false})
    for (const std::uint32_t node : order) {
      if (on_boundary[node] != first || blocked[node]) continue;
      kept[node] = true;
      for (const std::uint32_t e : edges_of[node])
        for (const std::uint32_t other : mesh.edges[e])
          if (other != node) blocked[other] = true;
    }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < count; ++node)
    if (kept[node]) nodes.push_back(node);
  return nodes;
}

/// The coarse node to whose region each fine node belongs; the surface of a volume belongs to nodes of the surface.
std::vector<std::uint32_t> regions(const Network& mesh, const NodeLists& edges_of,
                                   const std::vector<bool>& on_boundary,
                                   const std::vector<std::uint32_t>& kept) {
  std::vector<std::uint32_t> number(mesh.positions.size(), kNone);
  for (std::uint32_t k = 0; k < kept.size(); ++k) number[kept[k]] = k;
  std::vector<std::uint32_t> region = number;
  for (std::uint32_t node = 0; node < region.size(); ++node) {
    if (number[node] != kNone) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t e : edges_of[node]) {
      const std::uint32_t other = mesh.edges[e][0] == node ? mesh.edges[e][1] : mesh.edges[e][0];
      const double apart = length(mesh.positions[other] - mesh.positions[node]);
      if (number[other] == kNone || apart >= nearest) continue;
      if (!mesh.tets.empty() && on_boundary[node] && !on_boundary[other]) continue;
      nearest = apart;
      region[node] = number[other];
    }
  }
  return region;
}

template <class Item>
void keep_each_once(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

Network network_of(const Network& fine, const std::vector<std::uint32_t>& kept,
                   const std::vector<std::uint32_t>& region) {
  Network coarse;
  for (const std::uint32_t node : kept) coarse.positions.push_back(fine.positions[node]);
  for (const Edge& e : fine.edges)
    if (const auto [low, high] = std::minmax(region[e[0]], region[e[1]]); low != high)
      coarse.edges.push_back({low, high});
  for (const Triangle& t : fine.triangles) {
    Triangle c{region[t[0]], region[t[1]], region[t[2]]};
    std::sort(c.begin(), c.end());
    if (c[0] != c[1] && c[1] != c[2]) coarse.triangles.push_back(c);
  }
  for (const Tet& t : fine.tets) {
    Tet c{region[t[0]], region[t[1]], region[t[2]], region[t[3]]};
    std::sort(c.begin(), c.end());
    if (std::adjacent_find(c.begin(), c.end()) == c.end()) coarse.tets.push_back(c);
  }
  keep_each_once(coarse.edges);
  keep_each_once(coarse.triangles);
  keep_each_once(coarse.tets);
  return coarse;
}

/// Of a product of lengths: what is less is flat within rounding, and says nothing of where a point lies.
constexpr double kFlat = 1e-9;

/// Where a point lies with respect to a tetrahedron, a triangle or an edge.
struct Place {
  double distance = std::numeric_limits<double>::infinity();  // from the point to the nearest one of it [m]
  std::array<double, 4> weights{};                            // of the corners, whose sum that one is
};

Place place_on_edge(const Vec3d& x, const Vec3d& a, const Vec3d& b) {
  const Vec3d ab = b - a;
  const double square = dot(ab, ab);
  const double t = square > 0 ? std::clamp(dot(x - a, ab) / square, 0.0, 1.0) : 0;
  return {length(x - a - t * ab), {1 - t, t}};
}

Place place_on_triangle(const Vec3d& x, const std::array<Vec3d, 3>& p) {
  const Vec3d normal = cross(p[1] - p[0], p[2] - p[0]);
  const double square = dot(normal, normal);
  if (std::sqrt(square) > kFlat * length(p[1] - p[0]) * length(p[2] - p[0])) {
    Place inside;
    inside.distance = std::abs(dot(x - p[0], normal)) / std::sqrt(square);
    inside.weights[0] = dot(cross(p[1] - x, p[2] - x), normal) / square;
    inside.weights[1] = dot(cross(p[2] - x, p[0] - x), normal) / square;
    inside.weights[2] = 1 - inside.weights[0] - inside.weights[1];
    if (*std::min_element(inside.weights.begin(), inside.weights.end()) >= 0) return inside;
  }
  Place nearest;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place side = place_on_edge(x, p[k], p[(k + 1) % 3]);
    if (side.distance >= nearest.distance) continue;
    nearest.distance = side.distance;
    nearest.weights = {};
    nearest.weights[k] = side.weights[0];
    nearest.weights[(k + 1) % 3] = side.weights[1];
  }
  return nearest;
}

Place place_in_tet(const Vec3d& x, const std::array<Vec3d, 4>& p) {
  const double whole = six_volumes(p);
  if (std::abs(whole) > kFlat * length(p[1] - p[0]) * length(p[2] - p[0]) * length(p[3] - p[0])) {
    Place inside{0, {}};
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<Vec3d, 4> without = p;
      without[k] = x;
      inside.weights[k] = six_volumes(without) / whole;
    }
    if (*std::min_element(inside.weights.begin(), inside.weights.end()) >= 0) return inside;
  }
  Place nearest;
  for (std::size_t away = 0; away < 4; ++away) {
    const std::array<std::size_t, 3> corner = {(away + 1) % 4, (away + 2) % 4, (away + 3) % 4};
    const Place side = place_on_triangle(x, {p[corner[0]], p[corner[1]], p[corner[2]]});
    if (side.distance >= nearest.distance) continue;
    nearest.distance = side.distance;
    nearest.weights = {};
    for (std::size_t k = 0; k < 3; ++k) nearest.weights[corner[k]] = side.weights[k];
  }
  return nearest;
}

/// Finds where fine nodes take their values from.
class Interpolation {
 public:
  Interpolation(const Network& fine, const NodeLists& edges_of, const Network& coarse,
                const std::vector<std::uint32_t>& region)
      : fine_(fine),
        edges_of_(edges_of),
        coarse_(coarse),
        region_(region),
        coarse_edges_of_(items_of(coarse.positions.size(), coarse.edges)),
        coarse_triangles_of_(items_of(coarse.positions.size(), coarse.triangles)),
        coarse_tets_of_(items_of(coarse.positions.size(), coarse.tets)) {}

  Taps taps(std::uint32_t node) const {
    const Vec3d x = fine_.positions[node];
    std::vector<std::uint32_t> near = {region_[node]};
    for (const std::uint32_t e : edges_of_[node])
      for (const std::uint32_t other : fine_.edges[e]) near.push_back(region_[other]);
    keep_each_once(near);
    Place best;
    const std::uint32_t own = region_[node];
    std::array<std::uint32_t, 4> corners{own, own, own, own};
    const auto take = [&](const Place& place, const std::array<std::uint32_t, 4>& of) {
      if (!(place.distance < best.distance)) return;
      best = place;
      corners = of;
    };
    for (const std::uint32_t c : near)
      for (const std::uint32_t t : coarse_tets_of_[c]) {
        const Tet& of = coarse_.tets[t];
        take(place_in_tet(x, {position(of[0]), position(of[1]), position(of[2]), position(of[3])}), of);
      }
    for (const std::uint32_t c : near)
      for (const std::uint32_t t : coarse_triangles_of_[c]) {
        const Triangle& of = coarse_.triangles[t];
        take(place_on_triangle(x, {position(of[0]), position(of[1]), position(of[2])}),
             {of[0], of[1], of[2], of[0]});
      }
    best.distance *= 1 - 1e-9;  // of a triangle's own side the triangle is preferred
    for (const std::uint32_t c : near)
      for (const std::uint32_t e : coarse_edges_of_[c]) {
        const Edge& of = coarse_.edges[e];
        take(place_on_edge(x, position(of[0]), position(of[1])), {of[0], of[1], of[0], of[0]});
      }
    if (!(best.distance < std::numeric_limits<double>::infinity())) best.weights = {1};
    Taps taps;
    for (std::size_t k = 0; k < taps.size(); ++k) taps[k] = {corners[k], static_cast<float>(best.weights[k])};
    return taps;
  }

 private:
  const Vec3d& position(std::uint32_t coarse_node) const { return coarse_.positions[coarse_node]; }

  const Network& fine_;
  const NodeLists& edges_of_;
  const Network& coarse_;
  const std::vector<std::uint32_t>& region_;
  NodeLists coarse_edges_of_, coarse_triangles_of_, coarse_tets_of_;
};

}  // namespace

CoarseMesh coarsened(const Network& fine) {
  const NodeLists edges_of = items_of(fine.positions.size(), fine.edges);
  CoarseMesh made;
  const std::vector<bool> on_boundary = boundary_nodes(fine);
  made.of = kept_nodes(fine, edges_of, on_boundary);
  const std::vector<std::uint32_t> region = regions(fine, edges_of, on_boundary, made.of);
  made.network = network_of(fine, made.of, region);
  const Interpolation interpolation(fine, edges_of, made.network, region);
  for (std::uint32_t node = 0; node < fine.positions.size(); ++node) {
    if (made.of[region[node]] == node) {
      const std::uint32_t own = region[node];
      made.taps.push_back({Share{own, 1}, Share{own, 0}, Share{own, 0}, Share{own, 0}});
    } else {
      made.taps.push_back(interpolation.taps(node));
    }
  }
  return made;
}

}  // namespace weft::mesh
