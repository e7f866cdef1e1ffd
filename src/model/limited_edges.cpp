#include "model/limited_edges.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "element/spring/law.hpp"
#include "mesh/adjacency.hpp"
#include "model/fabric.hpp"

namespace weft {
namespace {

/// The edge between two nodes, the smaller number first; null: there is none.
template <class Edges>
auto find_edge(Edges& edges, std::uint32_t a, std::uint32_t b) {
  const std::pair ends(a, b);
  const auto edge =
      std::lower_bound(edges.begin(), edges.end(), ends,
                       [](const auto& one, const auto& wanted) { return std::pair(one.a, one.b) < wanted; });
  return edge != edges.end() && std::pair(edge->a, edge->b) == ends ? &*edge : nullptr;
}

}  // namespace

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

std::vector<LimitSpring> limit_springs(const Model& model, const Body& body) {
  std::vector<LimitSpring> springs;
  if (!body.fabric || !body.strain_limit) return springs;
  for (const LimitedEdge& edge : limited_edges(model, body))
    springs.push_back({edge.a - body.first_vertex, edge.b - body.first_vertex, edge.longest, 0});
  const FabricSheet sheet = fabric_sheet(model, body);
  const Moduli moduli = membrane_moduli(*body.fabric);
  for (const mesh::Triangle& t : sheet.triangles) {
    const auto at = places_of({sheet.position[t[0]], sheet.position[t[1]], sheet.position[t[2]]}, sheet.warp);
    const double area = membrane::Rest::of(at).area;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      LimitSpring* spring = find_edge(springs, std::min(t[k], t[next]), std::max(t[k], t[next]));
      if (spring == nullptr) continue;
      const double warp = at[next].warp - at[k].warp, weft = at[next].weft - at[k].weft;
      const double stiffness = modulus_along(moduli, warp, weft) * area / (warp * warp + weft * weft);
      spring->stiffness += static_cast<float>(spring::kStiffer * stiffness);
    }
  }
  return springs;
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
