// The energy of woven cloth, cut where it would resist without bound: what a matrix that never changes can bound from
// above. In double. Source: docs/solvers/projective_dynamics.md, Fabric.
#pragma once

#include "element/membrane/law.hpp"

namespace weft::bounded_yarns {

/// Of one square metre at rest [J/m²].
double energy(const Stiffness& stiffness, const membrane::Axes& f);
/// By F, at the end of a step that began with `start` and is 1/`rate` [s] long, damping included: the first
/// Piola-Kirchhoff stress [N/m]. Equation 14.
membrane::Axes stress(const membrane::Law& law, const membrane::Axes& f, const membrane::Axes& start,
                      double rate);

/// Of changes of each column of F [N/m]: whatever F is, the second derivative of the energy is nowhere above
/// diag(warp I, weft I), nor is that of damping above so much times the delay by the step. Equation 13.
struct Bound {
  double warp = 0, weft = 0;
};
Bound bound(const Stiffness& stiffness);

}  // namespace weft::bounded_yarns
