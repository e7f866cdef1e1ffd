#pragma once

#include <optional>
#include <vector>

#include "method/multigrid/grid_cycle.hpp"
#include "method/multigrid/mesh_cycle.hpp"
#include "method/pieces/piece_motion.hpp"
#include "method/solver.hpp"

namespace weft {

/// Cloth by BDF2, linearised once a substep and solved by conjugate gradients with V-cycles, to a residual; or by
/// Newton's method, to one of the equation itself. Iterations are recorded ahead, a few more than the last frames took;
/// where that was too little, the frame is repeated with more. Source: docs/solvers/multigrid.md, docs/solvers/fem.md.
class SolverMultigrid : public Solver {
 public:
  /// `newton_steps`: of a substep at most, where obstacles are not in the matrix; 0: it is linearised once, with them
  /// twice. Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const SolverInputs& inputs, double residual,
                                                std::uint32_t newton_steps = 0);

  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;
  bool adapt(gpu::Device& device, const Statistics& report) override;
  Result<void> bind_lists() override;

 private:
  Result<void> create_cycles(const CycleInputs& inputs);
  void set_iterations(gpu::Device& device, std::uint32_t iterations);

  std::optional<CycleInputs> inputs_;
  EnclosedGas gas_;
  gpu::Buffer<std::uint32_t> corners_;  // where the air pushes
  std::vector<GridCycle> grids_;
  std::vector<MeshCycle> meshes_;
  PieceMotion joined_, pieces_;   // of all bodies together; of each cloth and body
  std::uint32_t iterations_ = 0;  // that are recorded
  std::uint32_t most_seen_ = 0;   // that frames took since then
  std::uint32_t frames_seen_ = 0;
};

}  // namespace weft
