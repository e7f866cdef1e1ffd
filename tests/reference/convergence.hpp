// How fast the cycles of the multigrid reference converge.
#pragma once

#include "sheets.hpp"

namespace weft {

struct Convergence {
  double mean = 0, worst = 0, last = 0;  // factors of a cycle on the residual
  reference::Field solution;
};

/// Cycles until the residual is 10⁻⁹ of r, or 60 are done.
template <class Levels>
Convergence converge(const Levels& hierarchy, const reference::Field& r) {
  Convergence found;
  found.solution.resize(r.size());
  reference::Field left = r;
  const double first = norm(left);
  double before = first;
  int cycles = 0;
  while (norm(left) > 1e-9 * first && cycles < 60) {
    const reference::Field more = hierarchy.cycle(left);
    for (std::size_t a = 0; a < left.size(); ++a) found.solution[a] += more[a];
    left = residual(hierarchy.levels()[0], r, found.solution);
    found.last = norm(left) / before;
    found.worst = std::max(found.worst, found.last);
    before = norm(left);
    ++cycles;
  }
  found.mean = std::pow(norm(left) / first, 1.0 / cycles);
  return found;
}

}  // namespace weft
