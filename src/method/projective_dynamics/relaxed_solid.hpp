#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "method/projective_dynamics/relaxed_cloth.hpp"
#include "method/solid_buffers.hpp"

namespace weft {

/// Mirror: src/method/projective_dynamics/turned_tet.wgsl.
struct TurnedTet {
  Vec4f first, second, third;
};
static_assert(sizeof(TurnedTet) == 48);

/// The cycles of a corotated body: each finds what its tetrahedra pull by, and relaxes its nodes.
/// Source: docs/solvers/projective_dynamics.md, Bodies.
/// Reads   steps, position[parity]; of `relaxed` the aims.
/// Writes  the ways of its nodes, from those before the first cycle to those after the last.
/// Errors  Shader, Limit, OutOfMemory.
class RelaxedSolid {
 public:
  static Result<RelaxedSolid> create(const SolverInputs& inputs, const Body& body,
                                     const RelaxedState& relaxed, const ClothRates& rates);
  const std::vector<gpu::Dispatch>& dispatches() const { return dispatches_; }

 private:
  Result<void> create_cycle(const SolverInputs& inputs, const Body& body, const RelaxedState& relaxed,
                            std::size_t cycle);

  SolidBuffers solid_;
  gpu::Buffer<std::uint32_t> gathers_;  // rows of nodes, then their places in the tetrahedra's corners
  gpu::Buffer<TurnedTet> turned_;
  gpu::Buffer<Vec4f> pulls_;  // of tetrahedra at their corners [N]
  gpu::Buffer<RelaxedNodes> nodes_;
  std::vector<gpu::Dispatch> dispatches_;
};

}  // namespace weft
