#pragma once

#include <array>
#include <vector>

#include "method/multigrid/mesh_kernels.hpp"
#include "method/multigrid/mesh_lists.hpp"
#include "method/predicted.hpp"
#include "state/state.hpp"

namespace weft {

/// One implicit substep of a cloth that is a mesh: the linear system, one V-cycle, the new state.
/// Reads   steps, motions; position and velocity of both parities, of which [1 - parity] are those of a step
///         before; rest_position.
/// Writes  position[1 - parity] [m], predicted[parity] [m/s] of the cloth's vertices.
/// Errors  Shader, Limit, OutOfMemory.
class MeshCycle {
 public:
  static Result<MeshCycle> create(gpu::Device& device, const MeshKernels& kernels, const Model& model,
                                  const State& state, const Predicted& predicted,
                                  const gpu::Buffer<std::int32_t>* presses, const ClothModel& cloth);

  void record(gpu::ComputePass& pass, const MeshKernels& kernels) const;
  // Its parts, in their order.
  void record_system(gpu::ComputePass& pass, const MeshKernels& kernels) const;
  void record_matrices(gpu::ComputePass& pass, const MeshKernels& kernels) const;
  void record_down(gpu::ComputePass& pass, const MeshKernels& kernels) const;
  void record_up(gpu::ComputePass& pass, const MeshKernels& kernels) const;

  // What they leave on the GPU, for tests.
  const std::vector<MultigridMeshLevel>& levels() const { return levels_; }
  std::size_t tail() const { return tail_; }
  const gpu::Buffer<Vec4f>& vectors() const { return vectors_; }
  const gpu::Buffer<Vec4f>& blocks() const { return blocks_; }

 private:
  /// The lists, constant.
  struct ListBuffers {
    gpu::Buffer<std::uint32_t> row_starts, source_starts, product_starts;
    gpu::Buffer<Coupling> rows;
    gpu::Buffer<Share> sources, products, taps;
    gpu::Buffer<Vec4f> springs;
  };
  /// A level with the next coarser one. Those of the tail have galerkin only.
  struct Step {
    gpu::RawBuffer levels;
    gpu::BindGroup galerkin, smooth_down, residual, restrict_residual, prolong, smooth_begin, smooth_up;
  };

  Result<void> create_lists(gpu::Device& device, const MeshLists& lists, const std::vector<Spring>& springs);
  Result<void> create_buffers(gpu::Device& device, const MeshLists& lists, const ClothModel& cloth,
                              bool holds);
  Result<void> create_ends(const MeshKernels& kernels, const Model& model, const State& state,
                           const Predicted& predicted, const gpu::Buffer<std::int32_t>* presses);
  Result<void> create_steps(const MeshKernels& kernels);

  std::vector<MultigridMeshLevel> levels_;
  std::size_t tail_ = 0;  // the first of the levels whose cycle one workgroup does
  ListBuffers lists_;
  gpu::RawBuffer nodes_, tail_levels_;
  gpu::Buffer<std::int32_t> no_presses_;
  gpu::Buffer<Vec4f> place_, holds_, vectors_, blocks_;
  std::array<gpu::BindGroup, 2> predict_, finish_;  // by parity
  gpu::BindGroup gradient_, cycle_tail_;
  std::vector<Step> steps_;  // of each level
};

}  // namespace weft
