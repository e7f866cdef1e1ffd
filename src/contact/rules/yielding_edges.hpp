// The edges of cloth that are not to be stretched by what nothing has paid for, where ways are held back: one rule for
// the GPU and for the reference. Source: docs/contact.md, equation (6i).
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "model/model.hpp"

namespace weft {

/// Longer than any substep [s].
inline constexpr double kAnyTime = 1e9;

struct YieldingEdges {
  std::vector<mesh::Edge> edges;  // of all cloths, not of bodies
  double time = 0;                // pull_time() [s]
};

/// In which a pull crosses a triangle of the stiffest cloth [s]: ℓ √(ρ/E), ℓ of typical_altitude(), ρ/E the least of
/// all cloths, E the larger modulus along their threads. Infinite without cloth.
double pull_time(const Model& model);
/// The same of a body with volume, of its cells.
double pull_time_of_bodies(const Model& model);

/// For how long a substep pushes pairs apart that a solver's matrix holds, at most [s].
/// Source: docs/contact.md, equation (5a).
struct PushTimes {
  double of_one_cloth = kAnyTime, of_bodies = kAnyTime;
};
/// kOwnPushPulls times in which a pull crosses a triangle, or a cell.
PushTimes push_times(const Model& model);

/// None where substeps [s] are no longer than pull_time(): then edges give way by themselves.
YieldingEdges yielding_edges(const Model& model, double substep);

}  // namespace weft
