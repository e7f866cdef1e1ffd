#pragma once

#include <vector>

#include "method/contact_answer.hpp"
#include "method/multigrid/grid_cycle.hpp"
#include "method/multigrid/mesh_cycle.hpp"
#include "method/solver.hpp"

namespace weft {

/// Cloth by BDF2, linearised once a substep and solved by one V-cycle. Source: docs/solvers/multigrid.md.
class SolverMultigrid : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const SolverInputs& inputs);

  void record_predict(gpu::ComputePass& pass) const override;
  void record_solve(gpu::ComputePass& pass) const override;
  Result<void> bind_lists(const State& state, const ContactPairs& pairs) override {
    return contact_answer_.bind_lists(state, pairs);
  }
  SolverConstants constants() const override { return {}; }
  bool reads_step_before() const override { return true; }

 private:
  Result<void> create_cycles(const CycleInputs& inputs);

  std::vector<GridCycle> grids_;
  std::vector<MeshCycle> meshes_;
  ContactAnswer contact_answer_;
};

}  // namespace weft
