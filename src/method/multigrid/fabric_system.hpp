#pragma once

#include <vector>

#include "method/creases.hpp"
#include "method/fabric_buffers.hpp"
#include "method/multigrid/kernels.hpp"
#include "method/multigrid/mesh_system.hpp"

namespace weft {

/// Membranes, hinges and cords in the linear system of a cloth of fabric.
/// Source  docs/solvers/multigrid.md, Fabric.
/// Reads   steps; the cycle's place, and the start of its unknown.
/// Writes  the matrix of the finest level without inertia, and forces of elements.
/// Errors  Shader, Limit, OutOfMemory.
class FabricSystem {
 public:
  /// `blocks`: the entries of each block of the finest level.
  static Result<FabricSystem> create(const CycleInputs& inputs, const FabricKernels& kernels,
                                     const Body& body, const ElementPairs& pairs,
                                     std::span<const BlockEntries> blocks, const MeshSystem& mesh);

  const FabricBuffers& elements() const { return elements_; }
  /// As a substep begins.
  const Creases& creases() const { return creases_; }
  /// In their order, before the gradient's; taken out.
  std::vector<gpu::Dispatch> take_stages() { return std::move(stages_); }

 private:
  Result<void> create_buffers(const CycleInputs& inputs, const Body& body, const ElementPairs& pairs,
                              std::span<const BlockEntries> blocks);

  FabricBuffers elements_;
  Creases creases_;
  gpu::Buffer<float> bounds_;  // of hinges [N·m]
  gpu::Buffer<Vec4f> terms_;   // of membranes, then of limited edges: src/method/multigrid/cord_term.wgsl
  gpu::Buffer<Vec4f> wings_;   // slopes of hinges, four each [1/m]
  BlockParts parts_;
  std::vector<gpu::Dispatch> stages_;
};

}  // namespace weft
