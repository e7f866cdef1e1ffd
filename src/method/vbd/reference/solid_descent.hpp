#pragma once

#include <cstdint>

#include "mesh/adjacency.hpp"
#include "method/reference_ways.hpp"
#include "method/vbd/reference/fabric_descent.hpp"

namespace weft::reference {

/// What the nodes of a body with volume descend by. Source: docs/bodies.md, Node by node.
class SolidDescent {
 public:
  SolidDescent(const Model& model, const Body& body);

  /// At a node, counted from the body's first. `solid` is that of the body.
  NodePull pull(const Ways& ways, const SolidBody& solid, std::uint32_t node, double dt) const;

 private:
  mesh::Adjacency tets_of_;  // node -> its tetrahedra
};

}  // namespace weft::reference
