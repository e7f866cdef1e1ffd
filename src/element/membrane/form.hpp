// The energies as quadratic forms of three numbers of F, for solvers that take those as constraints. In double.
// Source: docs/elements.md, As constraints.
#pragma once

#include "element/membrane/law.hpp"

namespace weft::membrane {

/// ψ = ½ ε·K ε, but for a constant. Of Green and Yarn the strains and C; of neo-Hookean cloth how far F is from turning
/// all angles alike, by two numbers, and its area: K = diag(µ, µ, λ).
struct Form {
  Strain strain;
  Stiffness stiffness;
};
Form form(const Law& law, const Axes& f);

/// The slopes of the form's strains, where those that vanish as an axis or an angle closes are as steep as they are
/// open: a step of Newton's by them ends near rest, and not far beyond it.
Strain steep_slopes(Energy energy, const Axes& f);

}  // namespace weft::membrane
