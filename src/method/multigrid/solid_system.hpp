#pragma once

#include <vector>

#include "method/multigrid/kernels.hpp"
#include "method/multigrid/mesh_system.hpp"
#include "method/solid_buffers.hpp"

namespace weft {

/// Tetrahedra in the linear system of bodies with volume.
/// Source  docs/bodies.md, All nodes at once.
/// Reads   steps; the cycle's place, and the start of its unknown.
/// Writes  the matrix of the finest level without inertia, and forces of tetrahedra.
/// Errors  Shader, Limit, OutOfMemory.
class SolidSystem {
 public:
  /// `blocks`: the entries of each block of the finest level.
  static Result<SolidSystem> create(const CycleInputs& inputs, const SolidKernels& kernels,
                                    const multigrid::SystemBodies& bodies, const ElementPairs& pairs,
                                    std::span<const BlockEntries> blocks, const MeshSystem& mesh);

  /// Rows of nodes, then their places in `forces`.
  const gpu::Buffer<std::uint32_t>& gathers() const { return gathers_; }
  const gpu::Buffer<Vec4f>& forces() const { return forces_; }
  /// In their order, before the gradient's; taken out.
  std::vector<gpu::Dispatch> take_stages() { return std::move(stages_); }

 private:
  std::vector<SolidBuffers> elements_;  // of each body
  gpu::Buffer<Vec4f> terms_;            // src/method/multigrid/solid_term.wgsl
  gpu::Buffer<Vec4f> forces_;           // four a tetrahedron [N]
  gpu::Buffer<std::uint32_t> gathers_;
  BlockParts parts_;
  std::vector<gpu::Dispatch> stages_;
};

}  // namespace weft
