// The matrix of the global system of projective dynamics as pairs of nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// Two nodes of a cloth, counted from its first, and what the matrix L draws them together with [N/m]: L_ab is less
/// both, and L_aa the sum of its pairs'. Where one is negative it pushes them apart.
struct NodePair {
  std::uint32_t a = 0, b = 0;  // a < b
  double stretching = 0;       // of springs or membranes
  double bending = 0;          // whose forces it gives exactly
};

/// Of a cloth of fabric that is flat at rest: each pair once, sorted. Without damping, whose part is `stretching` by
/// the delay over the step. Source: docs/solvers/projective_dynamics.md, equation 15.
std::vector<NodePair> fabric_node_pairs(const Model& model, const Body& cloth);

}  // namespace weft
