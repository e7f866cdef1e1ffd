// What methods that move ways, not places, have alike (docs/solvers/xpbd.md, Precision).
#pragma once

#include <functional>

#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// For src/method/air.wgsl; without air one number, which is not read. Errors  Limit, OutOfMemory.
Result<gpu::Buffer<std::uint32_t>> corners_in_air(const SolverInputs& inputs);

/// The start of a substep that looks back on the one before (Method::history): every node's way without springs goes to
/// `aim`, the way to begin from to way_of(parity). Errors  Shader.
Result<gpu::Dispatch> create_start_way(
    const SolverInputs& inputs, const gpu::Buffer<std::uint32_t>& corners, const gpu::Buffer<Vec4f>& aim,
    const std::function<const gpu::Buffer<Vec4f>&(std::size_t parity)>& way_of);

/// The end of a substep, from the ways in position[1 - parity]; `history`: the next one may look back on it
/// (Method::history). Errors  Shader.
Result<gpu::Dispatch> create_end_way(const SolverInputs& inputs, bool history);

}  // namespace weft
