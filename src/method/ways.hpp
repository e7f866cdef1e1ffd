// What methods that move ways, not places, have alike (docs/solvers/xpbd.md, Precision).
#pragma once

#include <functional>
#include <vector>

#include "gpu/dispatch.hpp"
#include "method/enclosed_gas.hpp"
#include "method/solver.hpp"

namespace weft {

/// For src/method/air.wgsl; without air one number, which is not read. Errors  Limit, OutOfMemory.
Result<gpu::Buffer<std::uint32_t>> corners_in_air(const SolverInputs& inputs);

/// Where the ways of a substep of this parity begin.
using WayOf = std::function<const gpu::Buffer<Vec4f>&(std::size_t parity)>;

/// The gas in closed cloths, as a force on nodes before their ways are predicted: it goes to way_of(parity) [N].
/// Without gas it records nothing.
class GasOnWays {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<GasOnWays> create(const SolverInputs& inputs, const WayOf& way_of);
  void record(gpu::ComputePass& pass) const {
    gas_.record(pass);
    begin_way_.record(pass);
  }
  /// Of the kernel that predicts: what pushes on nodes (src/method/way_velocity.wgsl).
  std::vector<gpu::Constant> pushes(const SolverInputs& inputs) const;

 private:
  EnclosedGas gas_;
  gpu::Dispatch begin_way_;
};

/// The start of a substep that looks back on the one before (Method::history): every node's way without springs goes to
/// `aim`, the way to begin from to way_of(parity). Errors  Shader.
Result<gpu::Dispatch> create_start_way(const SolverInputs& inputs, const gpu::Buffer<std::uint32_t>& corners,
                                       const GasOnWays& gas, const gpu::Buffer<Vec4f>& aim,
                                       const WayOf& way_of);

/// The end of a substep, from the ways in position[1 - parity]; `history`: the next one may look back on it
/// (Method::history). Errors  Shader.
Result<gpu::Dispatch> create_end_way(const SolverInputs& inputs, bool history);

}  // namespace weft
