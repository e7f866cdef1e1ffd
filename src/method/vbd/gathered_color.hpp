#pragma once

#include <cstdint>
#include <vector>

#include "method/solver.hpp"

namespace weft {

/// The nodes of a colour of a body whose nodes gather their elements. Mirror: src/method/vbd/gathered_color.wgsl.
struct GatheredColor {
  std::uint32_t first = 0, count = 0;
  std::uint32_t first_node = 0, rows = 0;
};
static_assert(sizeof(GatheredColor) == 16);

/// Whether a kernel in which nodes descend answers obstacles: src/method/vbd/descended.wgsl.
inline std::vector<gpu::Constant> holds_constant(const SolverInputs& inputs) {
  return {{"kHolds", inputs.presses() != nullptr ? 1.0 : 0.0}};
}

}  // namespace weft
