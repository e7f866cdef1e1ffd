#pragma once

#include <vector>

#include "method/pieces/piece_motion.hpp"
#include "method/projective_dynamics/relaxed_fabric.hpp"
#include "method/projective_dynamics/relaxed_solid.hpp"
#include "method/projective_dynamics/relaxed_springs.hpp"
#include "method/ways.hpp"

namespace weft {

/// Cloth and bodies by projective dynamics: in each of a substep's cycles elements are projected, and their global
/// system is relaxed. Source: docs/solvers/projective_dynamics.md.
class SolverProjectiveDynamics : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const scene::Solver& settings, const SolverInputs& inputs);

  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;

 private:
  RelaxedState relaxed_;
  std::vector<RelaxedSprings> springs_;
  std::vector<RelaxedFabric> fabrics_;
  std::vector<RelaxedSolid> solids_;
  PieceMotion pieces_;
  GasOnWays gas_;
  gpu::Buffer<std::uint32_t> corners_;  // src/method/corners.wgsl; without air one number, which is not read

  gpu::Dispatch start_way_, begin_holds_, end_way_;
};

}  // namespace weft
