#pragma once

#include <vector>

#include "method/equal_cloths.hpp"
#include "method/multigrid/grid_level_params.hpp"
#include "method/multigrid/kernels.hpp"

namespace weft {

/// How many cloths like this one a cycle has room for in a binding and in a dispatch.
std::size_t most_cloths(const Body& body, const gpu::Limits& limits, bool air = false);

/// Of cloths that are grids.
class GridCycle : public Cycle {
 public:
  /// Errors  Limit, OutOfMemory.
  static Result<GridCycle> create(const CycleInputs& inputs, const GridKernels& kernels,
                                  const EqualCloths& cloths);

  // For tests.
  const std::vector<GridLevelParams>& shapes() const { return shapes_; }
  const gpu::Buffer<multigrid::BlockPart>& operators() const { return operators_; }

 private:
  Result<void> create_system(const CycleInputs& inputs, const GridKernels& kernels);
  Result<void> create_fine(const CycleInputs& inputs, const GridKernels& kernels);
  Result<void> create_coarse(const GridKernels& kernels);

  std::vector<GridLevelParams> shapes_;  // of its levels
  gpu::RawBuffer grid_;
  gpu::Buffer<multigrid::BlockPart> operators_;
  gpu::Buffer<std::array<std::uint32_t, 2>> springs_;  // their poses: src/method/multigrid/grid_springs.wgsl
};

}  // namespace weft
