#pragma once

#include "gpu/dispatch.hpp"
#include "method/creases.hpp"
#include "method/fabric_buffers.hpp"
#include "method/solver.hpp"

namespace weft {

/// One substep of a cloth of fabric: forces of membranes and hinges, gathered per node, then semi-implicit Euler.
/// Source  docs/elements.md; docs/solvers/mass_spring.md, Fabric.
/// Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity] of the cloth's vertices; its creases.
/// Errors  Shader, Limit, OutOfMemory.
class AdvanceFabric {
 public:
  static Result<AdvanceFabric> create(const SolverInputs& inputs, const Body& body);
  void record(gpu::ComputePass& pass) const;

 private:
  Result<void> create_forces(const SolverInputs& inputs, const Body& body);

  FabricBuffers fabric_;
  Creases creases_;
  gpu::Dispatch membranes_, bend_, moments_, advance_;
};

}  // namespace weft
