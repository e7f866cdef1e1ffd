#pragma once

#include <optional>
#include <vector>

#include "method/multigrid/fabric_system.hpp"
#include "method/multigrid/kernels.hpp"
#include "method/multigrid/mesh_lists.hpp"
#include "method/multigrid/solid_system.hpp"

namespace weft {

/// Of a cloth that is a mesh, or of bodies with volume.
class MeshCycle : public Cycle {
 public:
  /// Errors  Limit, OutOfMemory.
  static Result<MeshCycle> create(const CycleInputs& inputs, const MeshKernels& kernels,
                                  const multigrid::SystemBodies& bodies);

  /// As a substep begins: what bends leave for good.
  void record_creases(gpu::ComputePass& pass) const {
    if (fabric_) fabric_->creases().record(pass);
  }

  // For tests.
  const std::vector<MeshLevelParams>& shapes() const { return shapes_; }
  const gpu::Buffer<std::array<float, 2>>& blocks() const { return blocks_; }

 private:
  /// The lists, constant.
  struct ListBuffers {
    gpu::Buffer<std::uint32_t> row_starts, entries, source_starts, product_starts;
    gpu::Buffer<BlockEntries> targets;
    gpu::Buffer<Share> sources, products, taps;
  };

  Result<void> create_gas(const CycleInputs& inputs, const SharedKernels& kernels);
  Result<void> create_lists(gpu::Device& device, const MeshLists& lists);
  Result<void> create_springs(const CycleInputs& inputs, const MeshKernels& kernels, const Body& body,
                              const MeshLists& lists);
  Result<void> create_elements(const CycleInputs& inputs, const MeshKernels& kernels,
                               const multigrid::SystemBodies& bodies, const ElementPairs& pairs,
                               const MeshLists& lists);
  Result<void> create_search(const CycleInputs& inputs, const MeshKernels& kernels);
  Result<void> create_levels(const MeshKernels& kernels);

  std::vector<MeshLevelParams> shapes_;  // of its levels
  ListBuffers lists_;
  gpu::Buffer<Vec4f> springs_;                // of entries
  std::optional<FabricSystem> fabric_;        // instead of springs
  std::optional<SolidSystem> solid_;          // of bodies with volume
  gpu::Buffer<std::array<float, 2>> blocks_;  // three an entry of springs, else five
};

}  // namespace weft
