// A triangle of cloth that stretches and shears in its plane: constant strain, two material axes. In double.
// Source: docs/elements.md, Membrane.
#pragma once

#include <array>

#include "base/mat3.hpp"
#include "base/vec.hpp"
#include "element/orthotropic.hpp"

namespace weft::membrane {

/// Strains of the axes and of the angle between them; the matching stresses [N/m].
struct Triple {
  double warp = 0, weft = 0, shear = 0;
};

enum class Energy : std::uint8_t {
  Green,  // St. Venant-Kirchhoff: Green's strain
  Yarn,  // the extension of the yarns, and the cosine of the angle between them: Baraff and Witkin's measures
  NeoHookean  // stable neo-Hookean (Smith et al. 2018) in the plane: isotropic, of C12 and C33 alone
};

struct Law {
  Energy energy = Energy::Green;
  Stiffness stiffness;
  double delay = 0;  // τ of Kelvin and Voigt [s]: strain ε resists as ε + τ dε/dt does
};

/// Where the unit vectors of the material axes go: the columns of F, or of what multiplies them.
struct Axes {
  Vec3d warp, weft;
};

/// An axis that is shorter by this factor has no direction, and pulls nowhere.
inline constexpr double kMinStretch = 1e-9;

/// The axes where they are pressed as long as at rest. What Green's energy resists further pressure with vanishes as an
/// axis does, but not what throws it apart: a long step that knew no more would go far beyond its rest.
Axes unpressed(const Axes& f);

/// Three numbers of F, and their slopes by its columns.
struct Strain {
  Triple value;
  Axes warp, weft, shear;
};
/// Those whose rates damping resists: Green's where the energy is neo-Hookean.
Strain strain_of(Energy energy, const Axes& f);

/// A second derivative by the columns of F [N/m]; the block (weft, warp) is `mixed` transposed.
struct Hessian {
  Mat3 warp, mixed, weft;
};
Hessian operator+(const Hessian& a, const Hessian& b);
Hessian operator*(double s, const Hessian& a);
Axes operator*(const Hessian& h, const Axes& f);

/// Of one square metre at rest [J/m²].
double energy(const Law& law, const Axes& f);
/// By F: the first Piola-Kirchhoff stress [N/m].
Axes stress(const Law& law, const Axes& f);
Hessian hessian(const Law& law, const Axes& f);
/// The same without what could make it indefinite, in closed form. Equations 7 to 9.
Hessian positive_hessian(const Law& law, const Axes& f);
/// That of a step that first leads F by `way`: what presses here, or by this Hessian there, resists being turned by the
/// force that it has there, as if it pulled. Equations 7a to 9a.
Hessian held_hessian(const Law& law, const Axes& f, const Axes& way);

/// The stress that damping adds where F changes at a rate [N/m], and its derivative by that rate [N·s/m], which is
/// never indefinite. Equation 10.
Axes damping_stress(const Law& law, const Axes& f, const Axes& rate);
Hessian damping_hessian(const Law& law, const Axes& f);

/// At the end of a step that began with `start`, of which `rate` go into a second: the stress, damped by how much the
/// strain has changed, and how it changes with F [N/m], without what could make that indefinite. A step that only turns
/// the sheet is not damped.
struct StepStress {
  Axes stress;
  Hessian hessian;
};
StepStress step_stress(const Law& law, const Axes& f, const Axes& start, double rate);

/// A triangle at rest.
struct Rest {
  double area = 0;                       // [m²]
  std::array<MaterialPoint, 3> slope{};  // of each corner's shape function along both axes [1/m]

  /// Corners may go round either way; three in a line have no area, and no element.
  static Rest of(const std::array<MaterialPoint, 3>& corners);
};

using Corners = std::array<Vec3d, 3>;
using Blocks = std::array<std::array<Mat3, 3>, 3>;

/// F of corners at these places [m], or its rate by their velocities [m/s].
Axes deformation(const Rest& rest, const Corners& corners);
/// [N]; they sum to zero and turn nothing.
Corners forces(const Rest& rest, const Axes& stress);
/// The second derivative of the energy by the corners [N/m].
Blocks blocks(const Rest& rest, const Hessian& hessian);

}  // namespace weft::membrane
