#pragma once

#include <optional>
#include <vector>

#include "method/enclosed_gas.hpp"
#include "method/mass_spring/advance_fabric.hpp"
#include "method/mass_spring/advance_grid.hpp"
#include "method/mass_spring/advance_grid_twice.hpp"
#include "method/mass_spring/advance_mesh.hpp"
#include "method/mass_spring/advance_solid.hpp"
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

  std::uint32_t substeps_at_once() const override { return twice_.empty() ? 1 : 2; }
  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;
  void fill(StepBlock::Method& part) const override;

 private:
  /// Algorithm 1: fixed-point sums of springs, one by one or in blocks.
  struct SpringCentric {
    gpu::Buffer<std::int32_t> force;  // 3 * vertex_count
    std::optional<SpringForces> spring_forces;
    std::optional<SpringBlockForces> spring_block_forces;
    IntegrateForces integrate_forces;
  };

  void record_predict(gpu::ComputePass& pass) const;
  Result<void> create_gas(const SolverInputs& inputs);
  Result<void> create_air(const SolverInputs& inputs);
  Result<void> create_spring_centric(const scene::Solver& settings, const SolverInputs& inputs);
  Result<void> create_node_centric(const SolverInputs& inputs);

  std::uint32_t spring_count_ = 0;
  ForceFixedPoint fixed_point_;  // of spring_centric_
  std::optional<SpringCentric> spring_centric_;
  // One invocation per node; one dispatch per cloth.
  std::vector<AdvanceGrid> grids_;
  std::vector<AdvanceGridTwice> twice_;
  std::vector<AdvanceMesh> meshes_;
  std::vector<AdvanceFabric> fabrics_;
  std::vector<AdvanceSolid> solids_;
  EnclosedGas gas_;
  gpu::Dispatch push_by_gas_;  // without gas it records nothing
  gpu::Buffer<std::uint32_t> corners_;
  gpu::Dispatch push_by_air_;  // without air it records nothing
};

}  // namespace weft
