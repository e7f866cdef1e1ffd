#pragma once

#include "gpu/dispatch.hpp"
#include "method/solid_buffers.hpp"
#include "method/solver.hpp"

namespace weft {

/// One substep of a body with volume: forces of tetrahedra, gathered per node, then semi-implicit Euler.
/// Source  docs/bodies.md.
/// Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity] of the body's nodes.
/// Errors  Shader, Limit, OutOfMemory.
class AdvanceSolid {
 public:
  static Result<AdvanceSolid> create(const SolverInputs& inputs, const Body& body);
  void record(gpu::ComputePass& pass) const;

 private:
  SolidBuffers solid_;
  gpu::Buffer<std::uint32_t> gathers_;  // rows of nodes, then their forces
  gpu::Buffer<Vec4f> forces_;           // of the corners of all tetrahedra [N]
  gpu::Dispatch tets_, advance_;
};

}  // namespace weft
