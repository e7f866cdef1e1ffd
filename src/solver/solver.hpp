#pragma once

#include <cstdint>
#include <memory>

#include "base/result.hpp"
#include "gpu/kernel.hpp"
#include "model/step_limit.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft {

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
