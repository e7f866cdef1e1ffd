#pragma once

#include "gpu/dispatch.hpp"
#include "method/equal_cloths.hpp"
#include "method/solver.hpp"

namespace weft {

/// Two substeps of equal grid cloths in one dispatch, to the same bits as two of AdvanceGrid. For small cloths,
/// where a dispatch costs more than the step.
/// Source  docs/solvers/mass_spring.md, "Two steps at once".
/// Reads   two of steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity] of the cloths' vertices: the state after both.
/// Errors  Shader, OutOfMemory.
class AdvanceGridTwice {
 public:
  static Result<AdvanceGridTwice> create(const SolverInputs& inputs, const EqualCloths& cloths);
  void record(gpu::ComputePass& pass) const { dispatch_.record(pass); }

 private:
  gpu::RawBuffer grid_;
  gpu::Dispatch dispatch_;
};

}  // namespace weft
