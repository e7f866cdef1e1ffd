#include "model/tethers.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <queue>
#include <span>
#include <tuple>

#include "mesh/adjacency.hpp"
#include "mesh/sides.hpp"
#include "model/node_groups.hpp"

namespace weft {
namespace {

/// f32 places at rest are off by a part of 2⁻²⁴ of themselves: cloth at rest must not pull.
constexpr double kRounding = 1e-6;

struct Way {
  std::uint32_t to = 0;
  double length = 0;  // [m]
};
using Ways = std::vector<std::vector<Way>>;  // from each node of a body, which count from 0

/// From c to d over the edge a b of two triangles a b c and b a d laid into a plane; negative where the straight way
/// leaves them.
double across(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const Vec3d edge = (b - a) / length(b - a);
  const double s = dot(c - a, edge), t = dot(d - a, edge);
  const double rise = length(c - a - s * edge), fall = length(d - a - t * edge);
  const double crossing = s + (t - s) * rise / (rise + fall);
  return crossing < 0 || crossing > length(b - a) ? -1 : std::hypot(t - s, rise + fall);
}

/// Along edges, and straight from a triangle into the next: none is shorter than the way along the sheet.
Ways ways_of(const Model& model, const Body& body) {
  Ways ways(body.vertex_count);
  const auto place = [&](std::uint32_t node) { return model.rest_position[body.first_vertex + node]; };
  const auto join = [&](std::uint32_t a, std::uint32_t b, double way) {
    ways[a].push_back({b, way});
    ways[b].push_back({a, way});
  };
  const std::vector<mesh::Triangle> triangles = own_triangles(model, body);
  for (const auto& [a, b] : mesh::mesh_edges(triangles)) join(a, b, length(place(b) - place(a)));
  const std::vector<mesh::Side> sides = mesh::sorted_sides(triangles);
  mesh::for_each_edge(sides, [&](std::span<const mesh::Side> of_edge) {
    if (of_edge.size() != 2) return;
    const mesh::Triangle &t = triangles[of_edge[0].triangle], &u = triangles[of_edge[1].triangle];
    const std::uint32_t c = t[of_edge[0].corner], d = u[of_edge[1].corner];
    const double way = across(place(t[(of_edge[0].corner + 1) % 3]), place(t[(of_edge[0].corner + 2) % 3]),
                              place(c), place(d));
    if (way > 0) join(c, d, way);
  });
  return ways;
}

/// The island of each held node, by the number of one of its nodes.
std::vector<std::uint32_t> islands_of(const Model& model, const Body& body) {
  NodeGroups islands(body.vertex_count);
  const auto motion = [&](std::uint32_t node) { return model.motion[body.first_vertex + node]; };
  for (const auto& [a, b] : mesh::mesh_edges(own_triangles(model, body)))
    if (motion(a) != 0 && motion(a) == motion(b)) islands.join(a, b);
  std::vector<std::uint32_t> island;
  for (std::uint32_t node = 0; node < body.vertex_count; ++node) island.push_back(islands.of(node));
  return island;
}

/// The nearest nodes of the nearest islands, of each node, by Dijkstra's algorithm from all held nodes at once: a way
/// to one of a node's nearest islands leads only over nodes for which it is one of theirs.
std::vector<std::vector<Tether>> nearest_islands(const Model& model, const Body& body) {
  const Ways ways = ways_of(model, body);
  const std::vector<std::uint32_t> islands = islands_of(model, body);
  std::vector<std::vector<Tether>> nearest(body.vertex_count);
  using Reached = std::tuple<double, std::uint32_t, std::uint32_t>;  // how far, a node, from a held node
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached;
  for (std::uint32_t node = 0; node < body.vertex_count; ++node)
    if (model.kinematic(body.first_vertex + node)) reached.emplace(0, node, node);
  while (!reached.empty()) {
    const auto [far, node, from] = reached.top();
    reached.pop();
    std::vector<Tether>& own = nearest[node];
    const std::uint32_t island = islands[from];
    if (own.size() == kMostTethers ||
        std::any_of(own.begin(), own.end(),
                    [island, &islands](const Tether& tether) { return islands[tether.to] == island; }))
      continue;
    own.push_back({from, far});
    for (const Way& way : ways[node]) reached.emplace(far + way.length, way.to, from);
  }
  return nearest;
}

}  // namespace

TetherRows tethers_of(const Model& model) {
  TetherRows rows;
  rows.starts.assign(model.vertex_count() + 1, 0);
  for (const Body& body : model.bodies) {
    if (!body.slack) continue;
    std::vector<std::vector<Tether>> nearest = nearest_islands(model, body);
    // They are kept one after the other: of equally long ones rounding would decide which is the last.
    for (std::vector<Tether>& own : nearest)
      std::sort(own.begin(), own.end(), [](const Tether& a, const Tether& b) { return a.to < b.to; });
    for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
      const std::uint32_t v = body.first_vertex + node;
      rows.starts[v + 1] = model.kinematic(v) ? 0 : static_cast<std::uint32_t>(nearest[node].size());
    }
    for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
      if (model.kinematic(body.first_vertex + node)) continue;
      for (const auto& [from, far] : nearest[node]) {
        const std::uint32_t to = body.first_vertex + from;
        // A grid is a flat rectangle at rest, so that the straight way lies in it.
        const double way =
            body.grid ? length(model.rest_position[body.first_vertex + node] - model.rest_position[to]) : far;
        rows.tethers.push_back({to, (1 + *body.slack) * (1 + kRounding) * way});
      }
    }
  }
  std::partial_sum(rows.starts.begin(), rows.starts.end(), rows.starts.begin());
  return rows;
}

}  // namespace weft
