// What methods that move ways have alike where they answer obstacles themselves (docs/solvers/vbd.md, Obstacles).
#pragma once

#include <vector>

#include "gpu/dispatch.hpp"
#include "method/solver.hpp"
#include "method/ways.hpp"

namespace weft {

/// Words of `aim` for all nodes: of each a word of the method's own, and where it answers obstacles three more
/// (src/method/holds/node_holds.wgsl).
std::size_t aim_words(const SolverInputs& inputs);

/// Whether a kernel that moves ways answers obstacles: src/method/holds/held_way.wgsl.
std::vector<gpu::Constant> holds_constant(const SolverInputs& inputs);

/// After create_start_way: takes what obstacles press nodes with, and where it takes them begins there. Without
/// obstacles it records nothing. Errors  Shader.
Result<gpu::Dispatch> create_begin_holds(const SolverInputs& inputs, const gpu::Buffer<Vec4f>& aim,
                                         const WayOf& way_of);

/// As create_end_way, but without what restores a gap, where the method answers obstacles.
Result<gpu::Dispatch> create_end_held_way(const SolverInputs& inputs, const gpu::Buffer<Vec4f>& aim,
                                          bool history);

}  // namespace weft
