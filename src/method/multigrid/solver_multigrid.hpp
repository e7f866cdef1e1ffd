#pragma once

#include <vector>

#include "method/multigrid/grid_cycle.hpp"
#include "method/multigrid/mesh_cycle.hpp"
#include "method/solver.hpp"

namespace weft {

/// Cloth by BDF2, linearised once a substep and solved by one V-cycle. Source: docs/solvers/multigrid.md.
class SolverMultigrid : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const SolverInputs& inputs);

  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;

 private:
  Result<void> add_grid(const SolverInputs& inputs, const ClothModel& cloth);
  Result<void> add_mesh(const SolverInputs& inputs, const ClothModel& cloth);

  MultigridKernels kernels_;  // made where there is a grid
  MeshKernels mesh_kernels_;  // likewise, a mesh
  std::vector<GridCycle> grids_;
  std::vector<MeshCycle> meshes_;
};

}  // namespace weft
