#pragma once

#include <vector>

#include "method/multigrid/kernels.hpp"
#include "method/multigrid/level.hpp"

namespace weft {

/// Of a cloth that is a grid.
class GridCycle : public Cycle {
 public:
  /// Errors  Limit, OutOfMemory.
  static Result<GridCycle> create(const CycleInputs& inputs, const GridKernels& kernels,
                                  const ClothModel& cloth);

  // For tests.
  const std::vector<LevelOfGrid>& shapes() const { return shapes_; }
  const gpu::Buffer<multigrid::BlockPart>& operators() const { return operators_; }

 private:
  Result<void> create_system(const CycleInputs& inputs, const GridKernels& kernels);
  Result<void> create_fine(const CycleInputs& inputs, const GridKernels& kernels);
  Result<void> create_coarse(const GridKernels& kernels);

  std::vector<LevelOfGrid> shapes_;  // of its levels
  gpu::RawBuffer grid_;
  gpu::Buffer<multigrid::BlockPart> operators_;
};

}  // namespace weft
