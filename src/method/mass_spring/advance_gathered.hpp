#pragma once

#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// Gathers the forces of `count` nodes and integrates them. `nodes` is a uniform that begins as a NodeRange; `gathers`
/// has rows of nodes, then their entries of `forces` [N].
/// Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity] of these nodes.
/// Errors  Shader, OutOfMemory.
Result<gpu::Dispatch> create_advance_gathered(const SolverInputs& inputs, const gpu::RawBuffer& nodes,
                                              std::uint32_t count, const gpu::Buffer<std::uint32_t>& gathers,
                                              const gpu::Buffer<Vec4f>& forces);

}  // namespace weft
