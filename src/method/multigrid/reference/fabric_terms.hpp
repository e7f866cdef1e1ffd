// A cloth of fabric in the linear system of a substep, in double. Source: docs/solvers/multigrid.md, Fabric.
#pragma once

#include "method/multigrid/element_pairs.hpp"
#include "method/multigrid/reference/implicit_step.hpp"

namespace weft::reference {

/// Adds membranes, hinges and cords to the residual and the matrix of a step. `bounds`: of the hinges'
/// stiffness [N·m]. `rate`: of velocities by places [1/s].
void add_fabric(MeshStep& step, const FabricCloth& cloth, std::span<const Cord> cords,
                const ElementPairs& parts, std::span<const double> bounds, double rate);

}  // namespace weft::reference
