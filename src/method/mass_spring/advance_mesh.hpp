#pragma once

#include <array>

#include "element/spring/neighbours.hpp"
#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// Mirror of MeshParams in src/method/mass_spring/advance_mesh.wgsl.
struct MeshParams {
  std::uint32_t first = 0, count = 0;
  std::uint32_t padding[2] = {};
  std::array<Vec4f, kNeighbourKinds> kinds;  // stiffness [N/m], damping [N·s/m]
};
static_assert(sizeof(MeshParams) == 272 && offsetof(MeshParams, kinds) == 16);

/// One substep of a cloth of any shape: forces gathered per node over its neighbours, then semi-implicit
/// Euler.
/// Source  docs/solvers/mass_spring.md.
/// Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity] of the cloth's vertices.
/// Errors  Shader, Limit, OutOfMemory.
class AdvanceMesh {
 public:
  static Result<AdvanceMesh> create(const SolverInputs& inputs, const Body& body);
  void record(gpu::ComputePass& pass) const { dispatch_.record(pass); }

 private:
  gpu::RawBuffer params_;
  gpu::Buffer<std::uint32_t> slices_;
  gpu::Buffer<Neighbour> neighbours_;
  gpu::Dispatch dispatch_;
};

}  // namespace weft
