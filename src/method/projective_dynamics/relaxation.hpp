#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// What M⁻¹ L of a cloth cannot exceed, however its elements lie. Source: docs/solvers/projective_dynamics.md,
/// equation 6.
struct ClothRates {
  double stiffness = 0;  // [1/s²]
  double damping = 0;    // [1/s]

  /// κ of a step [s].
  double at(double step) const { return step * (step * stiffness + damping); }
  /// The step of a κ [s]; infinite without elements.
  double step_of(double rate) const;
};
ClothRates cloth_rates(const Model& model, const Body& cloth);

/// The largest κ at which each cycle of a substep leaves at most a tenth of every error.
double reached_rate(std::uint32_t iterations);

/// How a substep's global systems are relaxed: equations 4, 7 and 8.
struct Relaxation {
  double radius = 0;                        // ρ
  std::vector<std::vector<double>> cycles;  // of each cycle the weights of its iterations after the first

  /// How much of what is left a Jacobi step takes, in a cloth with this κ.
  double gain(double rate) const { return (1 + radius) / (1 + rate); }
};
/// `most_rate` is the largest κ of the scene's cloths.
Relaxation make_relaxation(double most_rate, std::uint32_t iterations);

}  // namespace weft
