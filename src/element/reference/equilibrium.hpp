// Where a sheet comes to rest. Source: docs/elements.md, The reference.
#pragma once

#include <vector>

#include "base/result.hpp"
#include "element/reference/newton_limits.hpp"
#include "element/reference/sheet_energy.hpp"

namespace weft::reference {

struct Equilibrium {
  std::vector<Vec3d> position;  // [m]
  NewtonReport report;
  bool stable = false;  // every small move raises the potential
};

/// From these places of the free nodes; held nodes are where they are at `time`.
/// Errors  Diverged: a force stays above the limit; a sheet that nothing holds does not come to rest.
Result<Equilibrium> equilibrium(const SheetEnergy& energy, std::vector<Vec3d> start,
                                const NewtonLimits& limits = {}, double time = 0);

}  // namespace weft::reference
