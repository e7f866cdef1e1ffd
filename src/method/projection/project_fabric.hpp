#pragma once

#include <array>
#include <span>
#include <vector>

#include "method/bent_hinges.hpp"
#include "method/fabric_buffers.hpp"
#include "method/projection/color.hpp"
#include "method/projection/multipliers.hpp"
#include "method/solver.hpp"

namespace weft {

/// A sweep over a cloth of fabric: its hinges, then its membranes, colour after colour, and the same way back.
/// Source  docs/solvers/xpbd.md, Fabric.
/// Reads   steps, position[parity] [m].
/// Writes  the ways of its nodes in position[1 - parity] [m].
/// Errors  Shader, Limit, OutOfMemory.
class ProjectFabric {
 public:
  static Result<ProjectFabric> create(const SolverInputs& inputs, const Body& body, Multipliers multipliers);
  /// `first`: whether it is the first of the substep, in which nothing has pulled yet.
  void record(gpu::ComputePass& pass, bool first) const;

 private:
  /// Elements of a kind, colour after colour.
  struct Ordered {
    gpu::Buffer<std::uint32_t> order;
    ColorRuns colors;
    gpu::Buffer<float> multiplier;
    Sweep first, later;  // where nothing has pulled yet, and after that
  };
  /// Without those whose number in `resistance` is 0; where it is empty, all.
  Result<Ordered> ordered(const SolverInputs& inputs, const ElementTable& table,
                          std::span<const double> resistance, std::size_t multipliers) const;
  Result<void> create_membranes(const SolverInputs& inputs, const Body& body);
  Result<void> create_hinges(const SolverInputs& inputs, const Body& body);

  Multipliers multipliers_ = Multipliers::Kept;
  FabricBuffers fabric_;
  Ordered membranes_, hinges_;
  BentHinges bent_;  // as a sweep begins
};

}  // namespace weft
