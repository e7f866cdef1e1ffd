#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.hpp"
#include "gpu/kernel.hpp"
#include "method/step_limit.hpp"
#include "scene/scene.hpp"
#include "method/predicted.hpp"
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

  /// Reads position[parity], velocity[parity]; writes the predicted position to position[1 - parity], and the
  /// velocity to SolverInputs::predicted.
  virtual void record_predict(gpu::ComputePass& pass) const = 0;
  /// Answers the contacts found at the predicted positions.
  virtual void record_solve(gpu::ComputePass& pass) const = 0;
  /// Whether record_two may stand for two substeps: only without contacts, which come between them.
  virtual bool takes_two() const { return false; }
  /// This substep and the next: reads position[parity], velocity[parity]; writes position[1 - parity],
  /// velocity[1 - parity], after both, to the same bits as one after the other.
  virtual void record_two(gpu::ComputePass&) const {}
  /// Takes over lists of pairs with other room. Errors  OutOfMemory.
  virtual Result<void> bind_lists(const State& state, const ContactPairs& pairs) = 0;
  virtual SolverConstants constants() const = 0;
  /// Whether record_predict also reads position[1 - parity] and velocity[1 - parity] as the substep before
  /// has left them, for nodes whose velocity's w is 1.
  virtual bool reads_step_before() const { return false; }
};

/// What a solver is made of. `contacts` is null where the scene has none.
struct SolverInputs {
  gpu::Device& device;
  const Model& model;
  const State& state;
  const Contacts* contacts = nullptr;
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
  std::optional<bool> two_steps = {};  // at once, where the solver can; none: where that is quicker

  /// What obstacles do to vertices, for a solver that solves with it; null: nothing.
  const gpu::Buffer<std::int32_t>* presses() const {
    if (contacts == nullptr || !contacts->pairs || contacts->pairs->presses.size() == 0) return nullptr;
    return &contacts->pairs->presses;
  }

  Predicted predicted() const {
    if (contacts != nullptr && contacts->pairs)
      return {&contacts->pairs->predicted, &contacts->pairs->predicted};
    return {&state.velocity[1], &state.velocity[0]};
  }
};

}  // namespace weft
