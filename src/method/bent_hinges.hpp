#pragma once

#include <array>
#include <vector>

#include "gpu/dispatch.hpp"
#include "method/creases.hpp"
#include "method/fabric_buffers.hpp"
#include "method/solver.hpp"

namespace weft {

/// How far the hinges of a cloth of fabric are bent at the ways so far, as a sweep of a method that moves ways begins.
/// Reads   steps, position[parity] and the ways in position[1 - parity] [m].
/// Writes  `bends`: each hinge's angle from its rest, and τ times its rate [rad], and behind them what `creases` keep.
/// Errors  Shader, Limit, OutOfMemory.
struct BentHinges {
  static Result<BentHinges> create(const SolverInputs& inputs, const Body& body, const FabricBuffers& fabric);

  std::vector<double> resistance;  // of each hinge: k̄ [N·m]
  bool resist = false;             // whether any does; where none does there are no bends
  gpu::Buffer<std::array<float, 2>> bends;
  Creases creases;  // recorded as a substep begins
  gpu::Dispatch bend;
};

}  // namespace weft
