#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// Mirror of MembraneLaw in src/element/membrane/law.wgsl.
struct MembraneLawBlock {
  Vec4f stiffness;           // C11, C12, C22, C33 [N/m]
  float delay = 0;           // [s]
  std::uint32_t energy = 0;  // membrane::Energy
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(MembraneLawBlock) == 32);

/// Mirror of FabricParams in src/method/mass_spring/fabric_params.wgsl.
struct FabricParams {
  std::uint32_t first = 0, count = 0;
  std::uint32_t triangles = 0, hinges = 0;
  MembraneLawBlock law;
};
static_assert(sizeof(FabricParams) == 48 && offsetof(FabricParams, law) == 16);

/// One substep of a cloth of fabric: forces of membranes and hinges, gathered per node, then semi-implicit Euler.
/// Source  docs/elements.md; docs/solvers/mass_spring.md, Fabric.
/// Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity] of the cloth's vertices.
/// Errors  Shader, Limit, OutOfMemory.
class AdvanceFabric {
 public:
  static Result<AdvanceFabric> create(const SolverInputs& inputs, const Body& body);
  void record(gpu::ComputePass& pass) const;

 private:
  using Two = std::array<std::uint32_t, 2>;
  using Four = std::array<std::uint32_t, 4>;
  Result<void> create_buffers(const SolverInputs& inputs, const Body& body);
  Result<void> create_forces(const SolverInputs& inputs);

  FabricParams layout_;
  gpu::RawBuffer params_;
  gpu::Buffer<std::uint32_t> corners_, gathers_;
  gpu::Buffer<Vec4f> slopes_, forces_;
  gpu::Buffer<Four> hinges_;
  gpu::Buffer<Two> couplings_;
  gpu::Buffer<float> rest_angles_, bends_;
  gpu::Dispatch membranes_, bend_, moments_, advance_;
};

}  // namespace weft
