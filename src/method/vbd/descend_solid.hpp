#pragma once

#include <cstdint>
#include <vector>

#include "gpu/dispatch.hpp"
#include "method/solid_buffers.hpp"
#include "method/solver.hpp"
#include "method/vbd/gathered_color.hpp"

namespace weft {

/// A sweep over a body with volume: its nodes, colour after colour. Source: docs/bodies.md, Node by node.
/// Reads   steps, position[parity] and `aim` [m].
/// Writes  the ways of its nodes in position[1 - parity] [m].
/// Errors  Shader, Limit, OutOfMemory.
class DescendSolid {
 public:
  static Result<DescendSolid> create(const SolverInputs& inputs, const Body& body,
                                     const gpu::Buffer<Vec4f>& aim);
  void record(gpu::ComputePass& pass) const;

 private:
  SolidBuffers solid_;
  gpu::Buffer<std::uint32_t>
      lists_;  // nodes, colour after colour; then rows of nodes and their places in tetrahedra
  std::vector<gpu::Buffer<GatheredColor>> params_;
  std::vector<gpu::Dispatch> colors_;
};

}  // namespace weft
