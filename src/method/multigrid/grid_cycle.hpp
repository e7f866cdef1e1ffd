#pragma once

#include <array>
#include <vector>

#include "method/multigrid/kernels.hpp"
#include "method/multigrid/level.hpp"
#include "method/predicted.hpp"
#include "state/state.hpp"

namespace weft {

/// One implicit substep of a grid cloth: the linear system, one V-cycle, the new state.
/// Reads   steps, motions; position and velocity of both parities, of which [1 - parity] are those of a step
///         before; rest_position.
/// Writes  position[1 - parity] [m], predicted[parity] [m/s] of the cloth's vertices.
/// Errors  Shader, Limit, OutOfMemory.
class GridCycle {
 public:
  static Result<GridCycle> create(gpu::Device& device, const MultigridKernels& kernels, const Model& model,
                                  const State& state, const Predicted& predicted,
                                  const gpu::Buffer<std::int32_t>* presses, const ClothModel& cloth);

  void record(gpu::ComputePass& pass, const MultigridKernels& kernels) const;
  // Its parts, in their order.
  void record_system(gpu::ComputePass& pass, const MultigridKernels& kernels) const;
  void record_matrices(gpu::ComputePass& pass, const MultigridKernels& kernels) const;
  void record_down(gpu::ComputePass& pass, const MultigridKernels& kernels) const;
  void record_up(gpu::ComputePass& pass, const MultigridKernels& kernels) const;

  // What they leave on the GPU, for tests.
  const std::vector<MultigridLevel>& levels() const { return levels_; }
  const gpu::Buffer<Vec4f>& place() const { return place_; }
  const gpu::Buffer<Vec4f>& vectors() const { return vectors_; }
  const gpu::Buffer<multigrid::BlockPart>& operators() const { return operators_; }

 private:
  /// A level, with the next coarser one, whose matrix it makes. From tail_ on that is all it does by itself.
  struct Own {
    gpu::RawBuffer levels;
    std::uint32_t count = 0, coarse_count = 0;  // nodes
    gpu::BindGroup galerkin, restrict_residual, smooth_down, residual, prolong, smooth_up;
  };

  Result<void> create_buffers(gpu::Device& device, const ClothModel& cloth, bool holds);
  Result<void> create_fine(const MultigridKernels& kernels, const Model& model, const State& state,
                           const Predicted& predicted, const gpu::Buffer<std::int32_t>* presses);
  Result<void> create_coarse(const MultigridKernels& kernels);

  std::vector<MultigridLevel> levels_;
  std::size_t tail_ = 0;  // the first of the levels that one workgroup does
  gpu::RawBuffer grid_, nodes_, tail_levels_;
  gpu::Buffer<std::int32_t> no_presses_;
  gpu::Buffer<Vec4f> place_, holds_, vectors_;
  gpu::Buffer<multigrid::BlockPart> operators_;
  std::array<gpu::BindGroup, 2> predict_, finish_;  // by parity
  gpu::BindGroup gradient_, galerkin_fine_, smooth_fine_, residual_fine_, correct_fine_, prolong_fine_;
  gpu::BindGroup cycle_tail_;
  std::vector<Own> own_;  // all levels but the coarsest; at least one
};

}  // namespace weft
