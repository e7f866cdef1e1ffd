#pragma once

#include <cstdint>

#include "method/projection/color.hpp"
#include "method/projection/multipliers.hpp"
#include "method/solid_buffers.hpp"
#include "method/solver.hpp"

namespace weft {

/// A sweep over a body with volume: its tetrahedra, colour after colour, and the same way back.
/// Source  docs/solvers/xpbd.md, Bodies.
/// Reads   steps, position[parity] [m].
/// Writes  the ways of its nodes in position[1 - parity] [m].
/// Errors  Shader, Limit, OutOfMemory.
class ProjectSolid {
 public:
  static Result<ProjectSolid> create(const SolverInputs& inputs, const Body& body, Multipliers multipliers);
  /// `first`: whether it is the first of the substep, in which nothing has pulled yet.
  void record(gpu::ComputePass& pass, bool first) const;

 private:
  SolidBuffers solid_;
  gpu::Buffer<std::uint32_t> order_;  // tetrahedra, colour after colour
  ColorRuns colors_;
  gpu::Buffer<float> multiplier_;  // nine a tetrahedron [kg·m²]
  Sweep first_, later_;            // where nothing has pulled yet, and after that
};

}  // namespace weft
