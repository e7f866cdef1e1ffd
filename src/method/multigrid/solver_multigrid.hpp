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
  Result<void> create_cycles(const CycleInputs& inputs);

  std::vector<GridCycle> grids_;
  std::vector<MeshCycle> meshes_;
};

}  // namespace weft
