#include "element/reference/equilibrium.hpp"

#include <cassert>

#include "element/reference/newton.hpp"

namespace weft::reference {

Result<Equilibrium> equilibrium(const SheetEnergy& energy, std::vector<Vec3d> start,
                                const NewtonLimits& limits, double time) {
  assert(start.size() == energy.sheet().rest.size());
  Equilibrium found{std::move(start)};
  for (std::size_t v = 0; v < found.position.size(); ++v)
    if (energy.sheet().is_held(v)) found.position[v] = energy.sheet().placed(v, time).position;
  Newton newton(energy);
  WEFT_SET(found.report, newton.solve({}, limits, found.position));
  found.stable = newton.stable(found.position);
  return found;
}

}  // namespace weft::reference
