#pragma once

#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// Integrates every node under the summed forces, and clears them.
/// Source  Sung et al., Algorithm 1, second part.
/// Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity]; force: 3 * vertex_count x int32, to zero.
/// Errors  Shader, OutOfMemory.
class IntegrateForces {
 public:
  static Result<IntegrateForces> create(const SolverInputs& inputs, const gpu::Buffer<std::int32_t>& force);
  void record(gpu::ComputePass& pass) const { dispatch_.record(pass); }

 private:
  gpu::Dispatch dispatch_;
};

}  // namespace weft
