#pragma once

#include <vector>

#include "element/spring/packed_springs.hpp"
#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// Mirror: src/method/xpbd/project_springs.wgsl.
struct SpringsOfColor {
  std::uint32_t first = 0, count = 0;
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(SpringsOfColor) == 16);

/// Cloth by extended position-based dynamics in small steps: springs are compliant constraints, projected colour after
/// colour. Source: docs/solvers/xpbd.md.
class SolverXpbd : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const scene::Solver& settings, const SolverInputs& inputs);

  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;

 private:
  Result<void> create_springs(const SolverInputs& inputs);
  Result<void> create_nodes(const SolverInputs& inputs);
  Result<std::vector<gpu::Dispatch>> create_sweep(const SolverInputs& inputs, bool first) const;

  gpu::Buffer<PackedSpring> springs_;  // colour after colour
  gpu::Buffer<SpringKind> kinds_;
  gpu::Buffer<float> multiplier_;  // of each spring [kg·m]
  std::vector<SpringsOfColor> colors_;
  std::vector<gpu::Buffer<SpringsOfColor>> color_uniforms_;

  gpu::Buffer<std::uint32_t> corners_;  // src/method/air.wgsl; without air one number, which is not read

  // While the springs are projected, position[1 - parity] holds ways from position[parity], not places.
  gpu::Dispatch predict_way_, end_way_;
  std::vector<gpu::Dispatch> first_sweep_, later_sweep_;  // a dispatch a colour
  std::uint32_t iterations_ = 1;
};

}  // namespace weft
