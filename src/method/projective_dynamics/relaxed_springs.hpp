#pragma once

#include <vector>

#include "element/spring/neighbours.hpp"
#include "method/projective_dynamics/relaxed_cloth.hpp"

namespace weft {

/// Mirror: src/element/spring/neighbour.wgsl.
struct SpringKindsBlock {
  std::array<Vec4f, kNeighbourKinds> kinds = {};
};
static_assert(sizeof(SpringKindsBlock) == 16 * kNeighbourKinds);

/// The cycles of a cloth of springs: each projects them, and relaxes its nodes.
/// Reads   steps, position[parity]; of `relaxed` the aims.
/// Writes  the ways of its nodes, from those before the first cycle to those after the last.
/// Errors  Shader, Limit, OutOfMemory.
class RelaxedSprings {
 public:
  static Result<RelaxedSprings> create(const SolverInputs& inputs, const Body& body,
                                       const RelaxedState& relaxed, const ClothRates& rates);
  const std::vector<gpu::Dispatch>& dispatches() const { return dispatches_; }

 private:
  gpu::Buffer<std::uint32_t> slices_;
  gpu::Buffer<Neighbour> neighbours_;
  gpu::Buffer<SpringKindsBlock> kinds_;
  gpu::Buffer<RelaxedNodes> nodes_;
  std::vector<gpu::Dispatch> dispatches_;
};

}  // namespace weft
