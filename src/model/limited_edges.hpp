// The edges of cloth that its strain limit keeps short.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// An edge of a cloth's triangles that is to be no longer than its strain limit lets it be.
/// Mirror: src/contact/proximity/limited_edge.wgsl.
struct LimitedEdge {
  std::uint32_t a = 0, b = 0;
  float longest = 0;  // [m]
};

/// All of cloths that have a strain limit, in the order of their vertices: those whose stretch is measured, of grids
/// without the diagonals, which shear lengthens. None of two nodes that the scene moves.
std::vector<LimitedEdge> limited_edges(const Model& model);
std::vector<LimitedEdge> limited_edges(const Model& model, const Body& body);  ///< of one of its bodies

/// The edge between two nodes, the smaller number first; null: there is none.
template <class Edges>
auto find_edge(Edges& edges, std::uint32_t a, std::uint32_t b) {
  const std::pair ends(a, b);
  const auto edge =
      std::lower_bound(edges.begin(), edges.end(), ends,
                       [](const auto& one, const auto& wanted) { return std::pair(one.a, one.b) < wanted; });
  return edge != edges.end() && std::pair(edge->a, edge->b) == ends ? &*edge : nullptr;
}

/// Of each of these springs the length beyond which it is stiffer, since it is one of `edges`; 0: it is none [m].
std::vector<float> longest_lengths(std::span<const LimitedEdge> edges, const Springs& springs);

}  // namespace weft
