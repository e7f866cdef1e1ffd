// The grids of the multigrid solver, from a cloth's own to one of about five nodes a side: one rule for the
// kernels and for the reference. Source: docs/solvers/multigrid.md.
#pragma once

#include <cstdint>
#include <vector>

namespace weft {

/// A side of this many nodes gets no coarser.
inline constexpr std::uint32_t kLeastSide = 5;

/// A side of the next coarser grid: N / 2 + 1 nodes. Coarse node I coincides with fine node 2 I, the last one with N -
/// 1, so that the last interval of an even side stays as it is while all others double.
constexpr std::uint32_t coarser_side(std::uint32_t nodes) {
  return nodes > kLeastSide ? nodes / 2 + 1 : nodes;
}

struct GridLevel {
  std::uint32_t nx = 0, ny = 0;  // nodes
  std::uint32_t interval_i = 1,
                interval_j = 1;  // of the finest grid, but for the last, which may be shorter:
  std::uint32_t last_i = 1, last_j = 1;
  /// Factor of the resistance to bending on this level, along i and along j. Of the second
  /// differences of a coarse field that is linear between its nodes, the fine grid sees half, in every second
  /// node, and in two lines for one.
  double bending_i = 1, bending_j = 1;
};

/// The levels of a grid, the finest first; the last is that which gets no coarser.
std::vector<GridLevel> grid_levels(std::uint32_t nx, std::uint32_t ny);

}  // namespace weft
