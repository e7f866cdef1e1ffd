// The energy of woven cloth, cut where it would resist without bound: what a matrix that never changes can bound from
// above. In double. Source: docs/solvers/projective_dynamics.md, Fabric.
#pragma once

#include "element/membrane/law.hpp"

namespace weft::bounded_yarns {

/// Of one square metre at rest [J/m²].
double energy(const Stiffness& stiffness, const membrane::Axes& f);
/// By F, at the end of a step that began with `start`, of which `rate` go into a second, damping included: the first
/// Piola-Kirchhoff stress [N/m]. Equation 14.
membrane::Axes stress(const membrane::Law& law, const membrane::Axes& f, const membrane::Axes& start,
                      double rate);

/// Of changes of each column of F [N/m]: whatever F is, a second derivative is nowhere above diag(warp I, weft I).
struct Bound {
  double warp = 0, weft = 0;
};
/// Of the energy. Equation 13.
Bound bound(const Stiffness& stiffness);
/// Of damping's, by the delay over the step, wherever the step began. Equation 14.
Bound damping_bound(const Stiffness& stiffness);

}  // namespace weft::bounded_yarns
