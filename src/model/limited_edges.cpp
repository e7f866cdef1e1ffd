#include "model/limited_edges.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "mesh/sides.hpp"

namespace weft {
namespace {

/// Of an edge, of which these are the sides: at a seam as long as both in the mean [m].
double rest_length(const Model& model, const Body& body, std::span<const mesh::Side> sides) {
  double sum = 0;
  for (const mesh::Side& side : sides) {
    const std::array<Vec3d, 3> corners = rest_corners(model, body, side.triangle);
    sum += length(corners[(side.start() + 1) % 3] - corners[side.start()]);
  }
  return sum / static_cast<double>(sides.size());
}

}  // namespace

std::vector<LimitedEdge> limited_edges(const Model& model, const Body& body) {
  std::vector<LimitedEdge> edges;
  if (!body.strain_limit) return edges;
  const auto triangles = std::span(model.triangles).subspan(body.first_triangle, body.triangle_count);
  mesh::for_each_edge(mesh::sorted_sides(triangles), [&](std::span<const mesh::Side> sides) {
    const auto [a, b] = sides[0].nodes;
    const bool is_diagonal = body.row() != 0 && b - a != 1 && b - a != body.row();
    if (is_diagonal || (model.kinematic(a) && model.kinematic(b))) return;
    edges.push_back({a, b, static_cast<float>((1 + *body.strain_limit) * rest_length(model, body, sides))});
  });
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
    const LimitedEdge* edge = find_edge(edges, s.node_a, s.node_b);
    lengths.push_back(edge != nullptr ? edge->longest : 0);
  }
  return lengths;
}

}  // namespace weft
