#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "method/predicted.hpp"
#include "state/state.hpp"

namespace weft {

/// One substep of a grid cloth: forces gathered per node, then semi-implicit Euler. Source:
/// docs/solvers/mass_spring.md. Reads   steps, motions; position[parity] [m], velocity[parity] [m/s],
/// rest_position [m]. Writes  position[1 - parity], velocity[1 - parity] of the cloth's vertices. Errors
/// Shader, OutOfMemory.
class AdvanceGrid {
 public:
  static Result<AdvanceGrid> create(gpu::Device& device, const Model& model, const State& state,
                                    const Predicted& predicted, const ClothModel& cloth,
                                    std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { kernel_.dispatch(pass, groups_[pass.parity()], count_); }

 private:
  gpu::Kernel kernel_;
  gpu::RawBuffer params_;
  std::array<gpu::BindGroup, 2> groups_;
  std::uint64_t count_ = 0;  // invocations, whole workgroups
};

}  // namespace weft
