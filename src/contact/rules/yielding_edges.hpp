// The edges of cloth that are not to be stretched by what nothing has paid for, where ways are held back: one rule for
// the GPU and for the reference. Source: docs/contact.md, equation (6i).
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "model/model.hpp"

namespace weft {

struct YieldingEdges {
  std::vector<mesh::Edge> edges;  // of all cloths, not of bodies
  double time = 0;                // pull_time() [s]
};

/// In which a pull crosses a triangle of the stiffest cloth [s]: ℓ √(ρ/E), ℓ of typical_altitude(), ρ/E the least of
/// all cloths, E the larger modulus along their threads. Infinite without cloth.
double pull_time(const Model& model);
/// For how long a substep pushes a pair of one cloth apart at most [s]: with `held`, where a solver's matrix holds such
/// pairs, kOwnPushPulls pull_time(). No more than a very long substep, so that it is finite.
/// Source: docs/contact.md, equation (5a).
double own_push_time(const Model& model, bool held);

/// None where substeps [s] are no longer than pull_time(): then edges give way by themselves.
YieldingEdges yielding_edges(const Model& model, double substep);

}  // namespace weft
