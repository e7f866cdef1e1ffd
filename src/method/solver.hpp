#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.hpp"
#include "contact/stages/stages.hpp"
#include "gpu/kernel.hpp"
#include "method/predicted.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft {

/// A method that moves the cloth.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Substeps that one call of record does at most. More than 1 only without contacts, which come between them.
  virtual std::uint32_t substeps_at_once() const { return 1; }
  /// Records `count` substeps: one, or substeps_at_once(), to the same bits as one after the other.
  /// Reads   position[parity], velocity[parity]; with a history (Method::history) also those of the other parity, as
  ///         the substep before has left them.
  /// Writes  position[1 - parity], velocity[1 - parity]: the state after them. The prediction before contact goes to
  ///         position[1 - parity] and, the velocity, to SolverInputs::predicted.
  /// A single substep calls the stages of contact in the order of contact/stages/stages.hpp.
  virtual void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const = 0;
  /// Takes in what a frame has reported, also one that is to be repeated since the solver had no room for its work.
  /// True: it records otherwise from now on.
  virtual bool adapt(gpu::Device&, const Statistics&) { return false; }
  /// Takes over the lists of contact, which have other room. Errors  OutOfMemory.
  virtual Result<void> bind_lists() { return {}; }
  /// Fills the solver's own part of the block that each substep's kernels read.
  virtual void fill(StepBlock::Method&) const {}
};

/// The inputs of a solver. `contacts` is null where the scene has none.
struct SolverInputs {
  gpu::Device& device;
  const GpuModel& model;
  const State& state;
  double step;  // the length of a substep, where frames are not cut [s]
  const Contacts* contacts = nullptr;
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
  std::optional<bool> two_steps = {};  // at once, where the solver can; none: where that is quicker
  bool air = false;                    // whether the air pushes on triangles

  /// Obstacles' demands on vertices, for a solver that includes them in its matrix; null: none.
  const gpu::Buffer<std::int32_t>* presses() const {
    if (contacts == nullptr || !contacts->pairs || contacts->pairs->presses.size() == 0) return nullptr;
    return &contacts->pairs->presses;
  }

  /// Pairs of cloth with cloth, for a solver whose matrix holds them apart; null: none.
  const ContactPairs* pairs() const {
    if (contacts == nullptr || !contacts->pairs || contacts->pairs->pair_sums.size() == 0) return nullptr;
    return &*contacts->pairs;
  }

  Predicted predicted() const {
    if (contacts != nullptr && contacts->pairs)
      return {&contacts->pairs->predicted, &contacts->pairs->predicted};
    return {&state.velocity[1], &state.velocity[0]};
  }
};

/// The solver of a scene's "solver" object, whose kind is not Auto (choose_method).
/// Errors  Shader, Limit, OutOfMemory, DeviceLost.
Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs);

}  // namespace weft
