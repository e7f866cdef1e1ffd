#pragma once

#include <array>

#include "element/spring/neighbours.hpp"
#include "gpu/kernel.hpp"
#include "method/predicted.hpp"
#include "state/state.hpp"

namespace weft {

/// Mirror of MeshParams in src/method/mass_spring/advance_mesh.wgsl.
struct MeshParams {
  std::uint32_t first = 0, count = 0;
  std::uint32_t padding[2] = {};
  std::array<Vec4f, kNeighbourKinds> kinds;  // stiffness [N/m], damping [N·s/m]
};
static_assert(sizeof(MeshParams) == 272 && offsetof(MeshParams, kinds) == 16);

/// One substep of a cloth of any shape: forces gathered per node over its neighbours, then semi-implicit
/// Euler. Source: docs/solvers/mass_spring.md. Reads   steps, motions; position[parity] [m], velocity[parity]
/// [m/s], rest_position [m]. Writes  position[1 - parity], velocity[1 - parity] of the cloth's vertices.
/// Errors  Shader, Limit, OutOfMemory.
class AdvanceMesh {
 public:
  static Result<AdvanceMesh> create(gpu::Device& device, const Model& model, const State& state,
                                    const Predicted& predicted, const ClothModel& cloth,
                                    std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { kernel_.dispatch(pass, groups_[pass.parity()], count_); }

 private:
  gpu::Kernel kernel_;
  gpu::RawBuffer params_;
  gpu::Buffer<std::uint32_t> slices_;
  gpu::Buffer<Neighbour> neighbours_;
  std::array<gpu::BindGroup, 2> groups_;
  std::uint32_t count_ = 0;
};

}  // namespace weft
