#pragma once

#include <vector>

#include "solver/contact_answer.hpp"
#include "solver/multigrid/grid_cycle.hpp"
#include "solver/solver.hpp"

namespace weft {

/// Cloth on grids by BDF2, linearised once a substep and solved by one V-cycle. Source:
/// docs/solvers/multigrid.md.
class SolverMultigrid : public Solver {
 public:
  /// Every cloth must be a grid. Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const SolverInputs& inputs);

  void record_predict(gpu::ComputePass& pass) const override;
  void record_solve(gpu::ComputePass& pass) const override;
  SolverConstants constants() const override { return {}; }
  bool reads_step_before() const override { return true; }

 private:
  MultigridKernels kernels_;
  std::vector<GridCycle> cloths_;
  ContactAnswer contact_answer_;
};

}  // namespace weft
