#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "solver/predicted.hpp"
#include "state/state.hpp"

namespace weft {

/// One substep of a grid cloth: forces gathered per node, then semi-implicit Euler. Source:
/// docs/solvers/mass_spring.md. Reads   steps, motions; position[parity] [m], velocity[parity] [m/s],
/// rest_position [m]. Writes  position[1 - parity], velocity[1 - parity] of the cloth's vertices. Errors
/// Shader, OutOfMemory.
class AdvanceGrid {
 public:
  static Result<AdvanceGrid> create(gpu::Device& device, const gpu::Kernel& kernel, const Model& model,
                                    const State& state, const Predicted& predicted, const ClothModel& cloth);
  static Result<gpu::Kernel> kernel(gpu::Device& device, std::uint32_t workgroup_size) {
    return gpu::Kernel::create(device, "mass_spring/advance_grid.wgsl", {}, workgroup_size);
  }
  void record(gpu::ComputePass& pass, const gpu::Kernel& kernel) const {
    kernel.dispatch(pass, groups_[pass.parity()], count_);
  }

 private:
  gpu::RawBuffer params_;
  std::array<gpu::BindGroup, 2> groups_;
  std::uint32_t count_ = 0;
};

/// Mirror of GridParams in shaders/mass_spring/advance_grid.wgsl.
struct GridParams {
  std::uint32_t first_vertex = 0, nx = 0, ny = 0;
  std::uint32_t uniform_weights = 0;
  Vec4f stiffness;    // structural, shear, bend [N/m]
  Vec4f rest_length;  // structural along i, along j, shear [m]
  float damping = 0;  // [N·s/m]
  float padding[3] = {};
};
static_assert(sizeof(GridParams) == 64 && offsetof(GridParams, damping) == 48);

GridParams grid_params(const ClothModel& cloth);

}  // namespace weft
