#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "element/spring/spring_kinds.hpp"

namespace weft {

inline constexpr std::uint32_t kBlockNodes = 448;  // src/method/mass_spring/spring_block_forces.wgsl
inline constexpr std::uint32_t kPlaceBits = 10;

/// Springs that are near each other, and their nodes. Mirror: src/method/mass_spring/spring_block_forces.wgsl.
struct SpringBlock {
  std::uint32_t first_node = 0, node_count = 0;  // in SpringBlocks::nodes; at most kBlockNodes
  std::uint32_t first_spring = 0, spring_count = 0;
};
static_assert(sizeof(SpringBlock) == 16);

/// Mirror: src/method/mass_spring/spring_block_forces.wgsl.
struct BlockSpring {
  std::uint32_t nodes_and_kind =
      0;                  // places of node a and b among the block's nodes, ten bits each, then the kind
  float rest_length = 0;  // [m]
};
static_assert(sizeof(BlockSpring) == 8);

struct SpringBlocks {
  std::vector<SpringBlock> blocks;
  std::vector<std::uint32_t> nodes;
  std::vector<BlockSpring> springs;
  std::vector<SpringKind> kinds;
};

/// Cuts the springs into blocks of at most kBlockNodes nodes along a Morton curve over their middles at rest.
/// Errors  Limit: more than 4,096 kinds.
Result<SpringBlocks> build_spring_blocks(std::span<const Vec3d> rest_position, const Springs& springs);

}  // namespace weft
