// What only pulls in a cloth of fabric, from a length on: edges beyond their strain limit, and threads of its seams.
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// Ends are numbered as the body's nodes, from 0. Mirror: src/method/multigrid/cord_terms.wgsl.
struct Cord {
  std::uint32_t a = 0, b = 0;
  float longest = 0;    // it pulls beyond that; 0: always [m]
  float stiffness = 0;  // [N/m]
  float damping = 0;    // while it pulls [N·s/m]
};

/// Of each edge of a body of fabric that has a strain limit, in the order of limited_edges.
/// Source: docs/solvers/multigrid.md, equation 5c.
std::vector<Cord> limit_cords(const Model& model, const Body& body);

/// These, and then the threads that pull at a body of fabric.
std::vector<Cord> cords_of(const Model& model, const Body& body);

}  // namespace weft
