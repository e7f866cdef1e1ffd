#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.hpp"
#include "gpu/kernel.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft {

/// The largest eigenvalues of a cloth's M^-1 K and M^-1 C, without drag.
struct NetworkSpectrum {
  double stiffness = 0;  // [1/s²]
  double damping = 0;    // [1/s]
};

/// What a step of a solver may be, and what decides it.
struct StepLimit {
  double highest_frequency = 0;         // of the spring network, undamped [rad/s]
  double highest_damping = 0;           // largest damping rate [1/s]
  double largest_step = 0;              // beyond which the integration is unstable [s]; 0: there is no limit
  std::vector<NetworkSpectrum> cloths;  // in the order of the scene
};

/// The constants of StepParams that a solver sets.
struct SolverConstants {
  std::uint32_t spring_count = 0;
  float force_scale = 1;  // fixed-point units per newton
  float force_limit = 0;  // [N]
};

/// A method that moves the cloth. A substep is record_predict, then collision at the predicted positions,
/// then record_solve.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Reads position[parity], velocity[parity]; writes the predicted position and velocity to [1 - parity].
  virtual void record_predict(gpu::ComputePass& pass) const = 0;
  /// Answers the contacts found at the predicted positions.
  virtual void record_solve(gpu::ComputePass& pass) const = 0;
  virtual SolverConstants constants() const = 0;
};

/// What a solver is made of. `contacts` is null where the scene has none.
struct SolverInputs {
  gpu::Device& device;
  const Model& model;
  const State& state;
  const Contacts* contacts = nullptr;
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
};

}  // namespace weft
