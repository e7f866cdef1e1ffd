#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// Mirror of src/method/multigrid/grid_level.wgsl: a level of a grid, and its place in the buffers.
struct GridLevelParams {
  std::uint32_t nx = 0, ny = 0;                        // nodes; 0: there is no such level
  std::uint32_t first_vector = 0, first_operator = 0;  // [vec4f], [vec2f]
  float bending_i = 0, bending_j = 0;                  // [N/m]
  float last_bend_i = 1, last_bend_j = 1;              // an interval by the last one, which may be shorter
  float rim = 0;                                       // part of the bending that boundary lines have
  std::uint32_t vectors = 0, operators = 0;            // of a cloth, all levels [vec4f], [vec2f]
  std::uint32_t padding = 0;
};
static_assert(sizeof(GridLevelParams) == 48);

inline std::uint32_t node_count(const GridLevelParams& level) { return level.nx * level.ny; }

namespace multigrid {

/// Parts of a coarse level's matrix, one vec2f a node each: src/method/multigrid/grid_block.wgsl.
using BlockPart = std::array<float, 2>;
inline constexpr std::uint32_t kBlocks = 5, kBlockParts = 3;
inline constexpr std::uint32_t kOperatorParts = kBlocks * kBlockParts;
/// Nodes a side of what a workgroup smooths on the levels between: src/method/multigrid/descend_coarse.wgsl, of the
/// coarser level, and ascend_coarse.wgsl.
inline constexpr std::uint32_t kCoarseTile = 6, kTile = 12;

}  // namespace multigrid

inline constexpr std::size_t kAllLevels = std::numeric_limits<std::size_t>::max();
/// The levels of a grid cloth, the finest first, no more than `most`; one buffer has the vectors of all, another one
/// the matrices of all but the finest. `air`: whether it pushes, and the finest has its vectors.
std::vector<GridLevelParams> grid_level_params(const Body& body, bool air = false,
                                               std::size_t most = kAllLevels);

}  // namespace weft
