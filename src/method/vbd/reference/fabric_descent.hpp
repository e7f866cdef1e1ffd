#pragma once

#include <cstdint>
#include <vector>

#include "mesh/adjacency.hpp"
#include "method/reference_hinges.hpp"
#include "method/stepper.hpp"
#include "method/sym3.hpp"
#include "model/model.hpp"

namespace weft::reference {

/// The pull of elements at a node, and how fast it grows against the node's way.
struct NodePull {
  Vec3d force;   // [N]
  Sym3 hessian;  // [N/m]
};

/// What the nodes of a cloth of fabric descend by. Source: docs/solvers/vbd.md, Fabric.
class FabricDescent {
 public:
  FabricDescent(const Model& model, const Body& body);

  /// A sweep begins: the moments of all hinges. `cloth` is that of the body.
  void begin_sweep(const Ways& ways, const FabricCloth& cloth, double dt);
  /// At a node, counted from the cloth's first.
  NodePull pull(const Ways& ways, const FabricCloth& cloth, std::uint32_t node, double dt) const;

 private:
  mesh::Adjacency membranes_of_, hinges_of_;  // node -> its elements
  std::vector<double> resistance_;            // of hinges: k̄ [N·m]
  std::vector<double> moments_;               // as the sweep began [N·m]
  std::vector<Bend> begun_;
};

}  // namespace weft::reference
