// How long a step may be, and how many make a frame: one rule for the solvers on the GPU and for the
// reference.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// The largest eigenvalues of a cloth's M^-1 K and M^-1 C, without drag.
struct NetworkSpectrum {
  double stiffness = 0;  // [1/s²]
  double damping = 0;    // [1/s]
};

/// Semi-implicit Euler with damping taken at the old velocity is stable for h² λ + 2 h μ < 4, where λ is the
/// largest eigenvalue of M^-1 K and μ that of M^-1 C plus the drag: h < 4 / (√(μ² + 4 λ) + μ). 0: any step is.
/// Source: docs/solvers/mass_spring.md, equation 7.
double largest_stable_step(double stiffness, double damping);

/// The largest step of a solver, and its cause.
struct StepLimit {
  double highest_frequency = 0;  // of the spring network, undamped [rad/s]
  double highest_damping = 0;    // largest damping rate [1/s]
  double largest_step = 0;       // beyond which the integration is unstable [s]; 0: there is no limit
  double longest_auto_step = 0;  // that "auto" gives where any is stable [s]; 0: the stable one decides
  std::vector<NetworkSpectrum> cloths;  // in the order of the scene
};

/// Why a frame [s] of this many substeps is unstable, as one sentence; empty where it is stable. Springs that
/// a step is too long for blow up, unless contact holds the vertices back: then the cloth only trembles.
std::string unstable_step(const StepLimit& limit, double frame, std::uint32_t substeps);

/// Of h √λ, where the gas's force is that of the places at the start of a step of first order.
inline constexpr double kMostOfGas = 2;
/// The same where it is that of the places ahead, in a step of second order that may be without history: 2/√3.
inline constexpr double kMostOfGasAhead = 1.1547005383792515;

/// The limit of a method whose steps are stable at any length but for the gas in closed cloths, which it takes as a
/// force: stable below `most` for h √λ, λ the gas's largest eigenvalue. Source: docs/pressure.md, The step.
StepLimit with_gas(StepLimit limit, const Model& model, double most);

/// The least of the limits of cloths with these spectra.
StepLimit least_step_limit(std::vector<NetworkSpectrum> cloths, double drag);

/// In a crumpled sheet the springs of a node can align; the sum of |entries| of a
/// row of M^-1 K then bounds the frequency: for a lattice √2 of the flat sheet's, with bend springs up
/// to 1.54. Measured: from a random start of a fifth of a cell without damping, 0.85 ends in an explosion
/// within 2,000 steps, 0.7 does not in 10,000.
inline constexpr double kStepSafety = 0.7;

/// The longest step that "auto" gives a method that is stable at any. Of the implicit solver, BDF2 at 1/480 s is within
/// 1 to 3 % of the exact motion of a sheet of 2 m [s].
inline constexpr double kImplicitStep = 1.0 / 480;
/// The same where contact gives a substep a second linear system: two err by less than half of what one does, so longer
/// steps err by less [s]. Source: docs/solvers/multigrid.md, Contact.
inline constexpr double kImplicitContactStep = 1.0 / 360;

/// The same where impulses answer obstacles that the solver would answer itself but for restitution or rigid bodies:
/// what they strike is stretched before its neighbours know [s]. Source: docs/rigid.md, Cloth.
inline constexpr double kBlowStep = 1.0 / 1920;

/// By how much longer than the one before it a step of the implicit solver may be (BDF2 is stable up to 1 +
/// √2); beyond it starts without history.
inline constexpr double kMostStepRatio = 2;
/// The ratio of a frame's steps to those of the one before it, for the solver; 0: it starts without history.
constexpr double step_ratio(std::uint32_t substeps_before, std::uint32_t substeps) {
  const double ratio = static_cast<double>(substeps_before) / substeps;
  return ratio > kMostStepRatio ? 0 : ratio;
}

/// The substeps of a frame that "auto" means for an explicit solver: the least multiple of 4 whose step is at
/// most kStepSafety times the largest stable one. Errors  Limit: more than scenes allow.
Result<std::uint32_t> stable_substeps(const scene::Scene& scene, const StepLimit& limit);
/// The same for a method that is stable at any step: the least multiple of `multiple` whose step is at most
/// longest_auto_step. Errors  Limit: more than scenes allow.
Result<std::uint32_t> long_substeps(const scene::Scene& scene, const StepLimit& limit, double multiple);

}  // namespace weft
