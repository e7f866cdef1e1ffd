#pragma once

#include <optional>
#include <vector>

#include "method/contact_answer.hpp"
#include "method/mass_spring/advance_grid.hpp"
#include "method/mass_spring/advance_grid_twice.hpp"
#include "method/mass_spring/advance_mesh.hpp"
#include "method/mass_spring/fixed_point.hpp"
#include "method/mass_spring/integrate_forces.hpp"
#include "method/mass_spring/spring_block_forces.hpp"
#include "method/mass_spring/spring_forces.hpp"
#include "method/solver.hpp"

namespace weft {

/// Mass-spring cloth, semi-implicit Euler: v += dt f / m, then x += dt v. Source:
/// docs/solvers/mass_spring.md.
class SolverMassSpring : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory, DeviceLost.
  static Result<std::unique_ptr<Solver>> create(const scene::Solver& settings, const SolverInputs& inputs);

  void record_predict(gpu::ComputePass& pass) const override;
  void record_solve(gpu::ComputePass& pass) const override;
  bool takes_two() const override { return !twice_.empty(); }
  void record_two(gpu::ComputePass& pass) const override;
  Result<void> bind_lists(const State& state, const ContactPairs& pairs) override {
    return contact_answer_.bind_lists(state, pairs);
  }
  SolverConstants constants() const override { return constants_; }

 private:
  /// Algorithm 1: fixed-point sums of springs, each by itself or in blocks.
  struct SpringCentric {
    gpu::Buffer<std::int32_t> force;  // 3 * vertex_count
    std::optional<SpringForces> spring_forces;
    std::optional<SpringBlockForces> spring_block_forces;
    IntegrateForces integrate_forces;
  };

  Result<void> create_spring_centric(const scene::Solver& settings, const SolverInputs& inputs);
  Result<void> create_node_centric(const SolverInputs& inputs);

  SolverConstants constants_;
  std::optional<SpringCentric> spring_centric_;
  // One invocation a node; a dispatch for each cloth.
  std::vector<AdvanceGrid> grids_;
  std::vector<AdvanceGridTwice> twice_;
  std::vector<AdvanceMesh> meshes_;
  ContactAnswer contact_answer_;
};

}  // namespace weft
