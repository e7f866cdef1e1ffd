// The matrix of the global system of projective dynamics as pairs of nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// Two nodes of a cloth, counted from its first, and what the matrix of a step h draws them together with, pull +
/// damping / h: L_ab is less that, and L_aa the sum of its pairs'. Where it is negative it pushes them apart.
struct NodePair {
  std::uint32_t a = 0, b = 0;  // a < b
  double pull = 0;             // [N/m]
  double damping = 0;          // [N·s/m]
  double bending = 0;          // the part of the pull that is bending's, whose forces it gives exactly [N/m]
};

/// Of a cloth of fabric that is flat at rest: each pair once, sorted.
/// Source: docs/solvers/projective_dynamics.md, equation 15.
std::vector<NodePair> fabric_node_pairs(const Model& model, const Body& cloth);
/// Of a body with volume, what no turn of its tetrahedra makes it exceed: likewise.
/// Source: docs/solvers/projective_dynamics.md, Bodies.
std::vector<NodePair> solid_node_pairs(const Model& model, const Body& body);

}  // namespace weft
