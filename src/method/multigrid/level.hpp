#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/host_model.hpp"

namespace weft {

/// Mirror of src/method/multigrid/level.wgsl: a level of a cloth's hierarchy, and its place in the buffers.
struct MultigridLevel {
  std::uint32_t nx = 0, ny = 0;                        // nodes; 0: there is no such level
  std::uint32_t first_vector = 0, first_operator = 0;  // [vec4f], [vec2f]
  float bending_i = 0, bending_j = 0;                  // [N/m]
  std::uint32_t bend_end_i = 0, bend_end_j = 0;        // second differences are taken about nodes 1 to this
  float rim = 0;                                       // part of the bending that boundary lines have
  std::uint32_t padding_a = 0, padding_b = 0, padding_c = 0;

  std::uint32_t node_count() const { return nx * ny; }
};
static_assert(sizeof(MultigridLevel) == 48);

namespace multigrid {

/// Vectors that each level has, one vec4f a node each: src/method/multigrid/level.wgsl.
inline constexpr std::uint32_t kResidual = 0, kInverse = 1, kDirection = 3, kFirst = 4, kSecond = 5;
inline constexpr std::uint32_t kVectors = 6;
/// Parts of a coarse level's matrix, one vec2f a node each: coarse_block.wgsl.
using BlockPart = std::array<float, 2>;
inline constexpr std::uint32_t kBlocks = 5, kBlockParts = 3;
inline constexpr std::uint32_t kOperatorParts = kBlocks * kBlockParts;
/// The cycle on levels of no more nodes is done by one workgroup: a step there takes less than it takes to
/// begin a dispatch.
inline constexpr std::uint32_t kTailNodes = 33 * 33;

}  // namespace multigrid

/// The levels of a grid cloth, the finest first; vectors of all stand in one buffer, as do the matrices of
/// all but the finest.
std::vector<MultigridLevel> multigrid_levels(const ClothModel& cloth);

/// Mirror of src/method/multigrid/spring_grid.wgsl.
struct SpringGrid {
  std::uint32_t first_vertex = 0, nx = 0, ny = 0;
  std::uint32_t uniform_weights = 0;
  Vec4f stiffness;    // structural, shear, bend [N/m]
  Vec4f rest_length;  // structural along i, along j, shear [m]
  float damping = 0;  // [N·s/m]
  float padding[3] = {};
};
static_assert(sizeof(SpringGrid) == 64 && offsetof(SpringGrid, damping) == 48);

SpringGrid spring_grid(const ClothModel& cloth);

}  // namespace weft
