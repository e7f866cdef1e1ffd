#pragma once

#include <cstdint>
#include <vector>

#include "gpu/dispatch.hpp"
#include "method/bent_hinges.hpp"
#include "method/fabric_buffers.hpp"
#include "method/solver.hpp"
#include "method/vbd/gathered_color.hpp"

namespace weft {

/// A sweep over a cloth of fabric: the moments of its hinges, then its nodes, colour after colour.
/// Source  docs/solvers/vbd.md, Fabric.
/// Reads   steps, position[parity] and `aim` [m].
/// Writes  the ways of its nodes in position[1 - parity] [m].
/// Errors  Shader, Limit, OutOfMemory.
class DescendFabric {
 public:
  static Result<DescendFabric> create(const SolverInputs& inputs, const Body& body,
                                      const gpu::Buffer<Vec4f>& aim);
  /// `first`: the first sweep of a substep.
  void record(gpu::ComputePass& pass, bool first) const;

 private:
  Result<void> create_moments(const SolverInputs& inputs, const Body& body);
  Result<void> create_colors(const SolverInputs& inputs, const Body& body, const gpu::Buffer<Vec4f>& aim);

  FabricBuffers fabric_;
  BentHinges bent_;
  // As a sweep begins: src/method/vbd/weigh_hinges.wgsl. One element that is not read where no hinge resists.
  gpu::Buffer<Vec4f> moments_;
  gpu::Buffer<FabricBuffers::Four> no_hinges_;
  gpu::Buffer<std::uint32_t>
      lists_;  // nodes, colour after colour; then rows of nodes and their places in elements
  std::vector<gpu::Buffer<GatheredColor>> params_;
  gpu::Dispatch weigh_;
  std::vector<gpu::Dispatch> colors_;
};

}  // namespace weft
