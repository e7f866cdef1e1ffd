#include "method/multigrid/cycle.hpp"

namespace weft {

void Cycle::record_system(gpu::ComputePass& pass) const {
  predict_.record(pass);
  gradient_.record(pass);
}

void Cycle::record_matrices(gpu::ComputePass& pass) const {
  for (const Level& level : levels_) level.coarsen.record(pass);
}

void Cycle::record_down(gpu::ComputePass& pass) const {
  for (std::size_t l = 0; l < tail_; ++l) {
    levels_[l].smooth_down.record(pass);
    levels_[l].residual.record(pass);
    levels_[l].restrict_down.record(pass);
  }
  tail_cycle_.record(pass);
}

void Cycle::record_up(gpu::ComputePass& pass) const {
  for (std::size_t l = tail_; l-- > 0;) {
    levels_[l].correct.record(pass);
    levels_[l].smooth_begin.record(pass);
    levels_[l].smooth_up.record(pass);
  }
  finish_.record(pass);
}

gpu::Dispatch::Bindings Cycle::predict_bindings(const CycleInputs& inputs, std::size_t parity) const {
  const State& state = inputs.state;
  return {state.steps,
          nodes_,
          state.position[parity],
          state.velocity[parity],
          state.position[1 - parity],
          state.velocity[1 - parity],
          inputs.model.rest_position,
          state.motions,
          place_,
          vectors_};
}

}  // namespace weft
