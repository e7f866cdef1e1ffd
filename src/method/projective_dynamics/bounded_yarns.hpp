// The energy of woven cloth, cut where it would resist without bound: what a matrix that never changes can bound from
// above. In double. Source: docs/solvers/projective_dynamics.md, Fabric.
#pragma once

#include "element/membrane/law.hpp"

namespace weft::bounded_yarns {

/// Of one square metre at rest [J/m²].
double energy(const Stiffness& stiffness, const membrane::Axes& f);
/// By F, with the damping of what changes at `rate` [1/s]: the first Piola-Kirchhoff stress [N/m].
membrane::Axes stress(const membrane::Law& law, const membrane::Axes& f, const membrane::Axes& rate);

/// Of changes of each column of F [N/m]: whatever F is, the second derivative of the energy is nowhere above
/// diag(warp I, weft I). Equation 13.
struct Bound {
  double warp = 0, weft = 0;
};
Bound bound(const Stiffness& stiffness);

}  // namespace weft::bounded_yarns
