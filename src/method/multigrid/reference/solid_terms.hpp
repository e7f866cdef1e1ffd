// A body with volume in the linear system of a substep, in double. Source: docs/bodies.md, All nodes at once.
#pragma once

#include "method/multigrid/element_pairs.hpp"
#include "method/multigrid/reference/implicit_step.hpp"

namespace weft::reference {

/// Adds the tetrahedra of bodies, whose first node is `first`, to the residual and the matrix of a step. `rate`: of
/// velocities by places [1/s].
void add_solids(MeshStep& step, std::span<const SolidBody> bodies, std::size_t first,
                const ElementPairs& parts, double rate);

}  // namespace weft::reference
