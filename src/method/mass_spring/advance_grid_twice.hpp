#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft {

/// Two substeps of a grid cloth in one dispatch, to the same bits as two of AdvanceGrid. For small cloths,
/// where a dispatch costs more than the step. Source: docs/solvers/mass_spring.md, "Two steps at once". Reads
/// two of steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m]. Writes  position[1
/// - parity], velocity[1 - parity] of the cloth's vertices: the state after both. Errors  Shader,
/// OutOfMemory.
class AdvanceGridTwice {
 public:
  static Result<AdvanceGridTwice> create(gpu::Device& device, const Model& model, const State& state,
                                         const ClothModel& cloth);
  void record(gpu::ComputePass& pass) const {
    kernel_.dispatch_groups(pass, groups_[pass.parity()], tiles_x_, tiles_y_);
  }

 private:
  gpu::Kernel kernel_;
  gpu::RawBuffer params_;
  std::array<gpu::BindGroup, 2> groups_;
  std::uint32_t tiles_x_ = 0, tiles_y_ = 0;
};

}  // namespace weft
