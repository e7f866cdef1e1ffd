#include "model/limited_edges.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "mesh/adjacency.hpp"

namespace weft {

std::vector<LimitedEdge> limited_edges(const Model& model, const Body& body) {
  std::vector<LimitedEdge> edges;
  if (!body.strain_limit) return edges;
  const auto triangles = std::span(model.triangles).subspan(body.first_triangle, body.triangle_count);
  for (const auto& [a, b] : mesh::mesh_edges(triangles)) {
    const bool is_diagonal = body.row() != 0 && b - a != 1 && b - a != body.row();
    if (is_diagonal || (model.kinematic(a) && model.kinematic(b))) continue;
    const double rest = length(model.rest_position[b] - model.rest_position[a]);
    edges.push_back({a, b, static_cast<float>((1 + *body.strain_limit) * rest)});
  }
  return edges;
}

std::vector<LimitedEdge> limited_edges(const Model& model) {
  std::vector<LimitedEdge> all;
  for (const Body& body : model.bodies) {
    const std::vector<LimitedEdge> edges = limited_edges(model, body);
    all.insert(all.end(), edges.begin(), edges.end());
  }
  return all;
}

std::vector<float> longest_lengths(std::span<const LimitedEdge> edges, const Springs& springs) {
  std::vector<float> lengths;
  lengths.reserve(springs.size());
  for (const Spring s : springs) {
    const std::pair ends(s.node_a, s.node_b);
    const auto edge = std::lower_bound(
        edges.begin(), edges.end(), ends,
        [](const LimitedEdge& e, const auto& wanted) { return std::pair(e.a, e.b) < wanted; });
    lengths.push_back(edge != edges.end() && std::pair(edge->a, edge->b) == ends ? edge->longest : 0);
  }
  return lengths;
}

}  // namespace weft
