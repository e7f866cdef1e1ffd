// What methods that move ways, not places, have alike (docs/solvers/xpbd.md, Precision).
#pragma once

#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// For src/method/air.wgsl; without air one number, which is not read. Errors  Limit, OutOfMemory.
Result<gpu::Buffer<std::uint32_t>> corners_in_air(const SolverInputs& inputs);

/// The end of a substep, from the ways in position[1 - parity]; `history`: the next one may look back on it
/// (Method::history). Errors  Shader.
Result<gpu::Dispatch> create_end_way(const SolverInputs& inputs, bool history);

}  // namespace weft
