#pragma once

#include <vector>

#include "method/fabric_buffers.hpp"
#include "method/projective_dynamics/node_pairs.hpp"
#include "method/projective_dynamics/relaxed_cloth.hpp"

namespace weft {

/// A pair of nodes as one of them sees it. Mirror: src/method/projective_dynamics/fabric_pair.wgsl.
struct FabricPair {
  std::uint32_t other = 0;
  float pull = 0, damping = 0, bending = 0;  // [N/m], [N·s/m], [N/m]
};
static_assert(sizeof(FabricPair) == 16);

/// The cycles of a cloth of fabric that is flat at rest: each finds what its membranes and its bending pull by, and
/// relaxes its nodes. Source: docs/solvers/projective_dynamics.md, Fabric.
/// Reads   steps, position[parity]; of `relaxed` the aims.
/// Writes  the ways of its nodes, from those before the first cycle to those after the last.
/// Errors  Shader, Limit, OutOfMemory.
class RelaxedFabric {
 public:
  static Result<RelaxedFabric> create(const SolverInputs& inputs, const Body& body,
                                      const RelaxedState& relaxed, const ClothRates& rates);
  const std::vector<gpu::Dispatch>& dispatches() const { return dispatches_; }

 private:
  Result<void> create_buffers(const SolverInputs& inputs, const Body& body);

  FabricBuffers fabric_;
  gpu::Buffer<std::uint32_t> gathers_;  // rows of nodes, then their places in the membranes' corners
  gpu::Buffer<std::uint32_t> slices_;   // of pairs, as those of neighbours
  gpu::Buffer<FabricPair> pairs_;
  gpu::Buffer<RelaxedNodes> nodes_;
  std::vector<gpu::Dispatch> dispatches_;
};

}  // namespace weft
