#pragma once

#include <vector>

#include "base/vec.hpp"

namespace weft::reference {

/// What moves while elements are projected: ways from the places at the start of the substep.
struct Ways {
  const std::vector<Vec3d>& start;   // [m]
  std::vector<Vec3d> way;            // [m]
  std::vector<double> inverse_mass;  // 0: prescribed [1/kg]

  Vec3d place(std::size_t node) const { return start[node] + way[node]; }
};

}  // namespace weft::reference
