// From one level of the multigrid solver to the next. Source: docs/solvers/multigrid.md.
#pragma once

#include "method/multigrid/grid_levels.hpp"
#include "method/multigrid/reference/grid_operator.hpp"

namespace weft::reference {

/// Where a fine node's value comes from along one side: two coarse nodes and their weights.
struct Taps {
  std::array<std::uint32_t, 2> node{};
  std::array<double, 2> weight{};
};
/// Of fine node i of n; the coarse side has coarser_side(n) nodes.
Taps taps(std::uint32_t i, std::uint32_t n);

/// P e: a coarse field on the fine grid, linear between coarse nodes, 0 where fine nodes are fixed.
Field prolonged(const Field& coarse, const GridOperator& fine);
/// Pᵀ r.
Field restricted(const Field& residual, const GridOperator& fine);
/// Pᵀ A P of the nine-point part of `fine`; the bending is that of `level` times `bending`.
GridOperator coarsened(const GridOperator& fine, const GridLevel& level, const GridBending& bending);

}  // namespace weft::reference
