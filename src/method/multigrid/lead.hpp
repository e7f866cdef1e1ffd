#pragma once

#include <algorithm>

namespace weft::multigrid {

/// How far along its way to the start an element is taken, by the square of how far it turns or is stretched there.
/// Source: docs/solvers/multigrid.md, equation 5b. Mirror: src/method/multigrid/lead.wgsl.
inline double lead_of(double turn) {
  constexpr double kFarTurn = 1.0 / 16;
  const double far = turn / kFarTurn;
  return std::max(0.0, 1 - far * far);
}

}  // namespace weft::multigrid
