// The edges of cloth that its strain limit keeps short.
#pragma once

#include <cstdint>
#include <span>
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

/// An edge of fabric beyond its strain limit: a spring that only pulls. Ends are numbered as the body's nodes, from 0.
/// Mirror: src/method/multigrid/limit_terms.wgsl.
struct LimitSpring {
  std::uint32_t a = 0, b = 0;
  float longest = 0;    // [m]
  float stiffness = 0;  // beyond that [N/m]
};

/// Of each edge of a body of fabric that has a strain limit, in the order of limited_edges.
/// Source: docs/solvers/multigrid.md, equation 5c.
std::vector<LimitSpring> limit_springs(const Model& model, const Body& body);

/// Of each of these springs the length beyond which it is stiffer, since it is one of `edges`; 0: it is none [m].
std::vector<float> longest_lengths(std::span<const LimitedEdge> edges, const Springs& springs);

}  // namespace weft
