#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "method/predicted.hpp"
#include "state/state.hpp"

namespace weft {

/// Integrates every node under the summed forces, and clears them. Source: Sung et al., Algorithm 1, second
/// part. Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m]. Writes
/// position[1 - parity], velocity[1 - parity]; force: 3 * vertex_count x int32, to zero. Errors  Shader,
/// OutOfMemory.
class IntegrateForces {
 public:
  static Result<IntegrateForces> create(gpu::Device& device, const Model& model, const State& state,
                                        const Predicted& predicted, const gpu::Buffer<std::int32_t>& force,
                                        std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { kernel_.dispatch(pass, groups_[pass.parity()], count_); }

 private:
  gpu::Kernel kernel_;
  std::array<gpu::BindGroup, 2> groups_;
  std::size_t count_ = 0;
};

}  // namespace weft
