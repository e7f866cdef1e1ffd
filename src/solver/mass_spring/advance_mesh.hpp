#pragma once

#include <array>

#include "element/neighbours.hpp"
#include "gpu/kernel.hpp"
#include "solver/predicted.hpp"
#include "state/state.hpp"

namespace weft {

/// Mirror of VertexRange in shaders/mass_spring/advance_mesh.wgsl.
struct VertexRange {
  std::uint32_t first = 0, count = 0;
  std::uint32_t padding[2] = {};  // to a multiple of 16 bytes
};

/// One substep of a cloth of any shape: forces gathered per node over its neighbours, then semi-implicit
/// Euler. Source: docs/solvers/mass_spring.md. Reads   steps, motions; position[parity] [m], velocity[parity]
/// [m/s], rest_position [m]. Writes  position[1 - parity], velocity[1 - parity] of the cloth's vertices.
/// Errors  Shader, Limit, OutOfMemory.
class AdvanceMesh {
 public:
  static Result<AdvanceMesh> create(gpu::Device& device, const gpu::Kernel& kernel, const Model& model,
                                    const State& state, const Predicted& predicted, const ClothModel& cloth);
  static Result<gpu::Kernel> kernel(gpu::Device& device, std::uint32_t workgroup_size) {
    return gpu::Kernel::create(device, "mass_spring/advance_mesh.wgsl", {}, workgroup_size);
  }
  void record(gpu::ComputePass& pass, const gpu::Kernel& kernel) const {
    kernel.dispatch(pass, groups_[pass.parity()], count_);
  }

 private:
  gpu::RawBuffer range_;
  gpu::Buffer<std::uint32_t> offsets_;
  gpu::Buffer<Neighbour> neighbours_;
  std::array<gpu::BindGroup, 2> groups_;
  std::uint32_t count_ = 0;
};

}  // namespace weft
