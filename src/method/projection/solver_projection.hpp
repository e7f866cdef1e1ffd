#pragma once

#include <array>
#include <vector>

#include "element/spring/packed_springs.hpp"
#include "method/projection/color.hpp"
#include "method/projection/project_fabric.hpp"
#include "method/projection/project_solid.hpp"
#include "method/solver.hpp"
#include "method/ways.hpp"

namespace weft {

/// Cloth and bodies by position-based dynamics: springs, membranes, hinges and tetrahedra are compliant constraints,
/// projected colour after colour. Source: docs/solvers/xpbd.md; where multipliers are forgotten docs/solvers/pbd.md.
class SolverProjection : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const SolverInputs& inputs, std::uint32_t iterations,
                                                Multipliers multipliers);

  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;

 private:
  Result<void> create_springs(const SolverInputs& inputs);
  Result<void> create_nodes(const SolverInputs& inputs);
  Result<void> create_holds(const SolverInputs& inputs);
  Result<void> create_tethers(const SolverInputs& inputs);
  Result<Sweep> create_sweep(const SolverInputs& inputs, bool pulled) const;

  gpu::Buffer<PackedSpring> springs_;  // colour after colour
  gpu::Buffer<SpringKind> kinds_;
  gpu::Buffer<float> multiplier_;  // of each spring [kg·m]
  ColorRuns colors_;

  GasOnWays gas_;
  gpu::Buffer<std::uint32_t> corners_;  // src/method/corners.wgsl; without air one number, which is not read

  std::vector<ProjectFabric> fabrics_;
  std::vector<ProjectSolid> solids_;

  // While elements are projected, position[1 - parity] holds ways from position[parity], not places.
  gpu::Buffer<std::array<std::uint32_t, 2>> tethers_;  // rows of nodes, then a held node and the bits of m
  gpu::Dispatch predict_way_, keep_tethers_, end_way_;
  gpu::Buffer<Vec4f> aim_;                     // how far obstacles move each node [m]; node_holds.wgsl
  gpu::Dispatch begin_holds_, project_holds_;  // where it answers obstacles
  Sweep first_sweep_, later_sweep_;            // over springs
  std::uint32_t iterations_ = 1;
  Multipliers multipliers_ = Multipliers::Kept;
};

}  // namespace weft
