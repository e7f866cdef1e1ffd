// The matrix of one level of the multigrid solver. Source: docs/solvers/multigrid.md.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "method/sym3.hpp"

namespace weft::reference {

using Field = std::vector<Vec3d>;  // a vector for each node, row by row

/// Adds d (e_a - e_b)(e_a - e_b)ᵀ for a spring between nodes that are two apart.
struct FarSpring {
  std::uint32_t a = 0, b = 0;
  Sym3 block;  // [N/m]
};

/// Resistance to bending: k/2 |x(m-1) - (1 + r) x(m) + r x(m+1)|² for each inner node m of each row, and of
/// each column; half of it along the boundary, where there is cloth on one side only. [N/m]
struct GridBending {
  double along_i = 0, along_j = 0;
  double last_i = 1, last_j = 1;  // r of the last m: an interval by the last one; 1 elsewhere
  bool uniform = false;           // along the boundary too it counts in full
};

/// Of a node: its own block, and those towards (i+1, j), (i, j+1), (i+1, j+1) and (i-1, j+1).
using StencilRow = std::array<Sym3, 5>;

/// A symmetric matrix over a grid: nine points of 3 x 3 blocks, far springs, bending. Rows and columns of
/// fixed nodes are not there.
struct GridOperator {
  std::uint32_t nx = 0, ny = 0;
  std::vector<StencilRow> rows;  // [N/m]
  std::vector<FarSpring> far;
  GridBending bending;
  std::vector<bool> fixed;

  std::size_t size() const { return rows.size(); }
  /// A x; x must be 0 where nodes are fixed.
  Field apply(const Field& x) const;
  /// The diagonal's blocks, where nodes are fixed too.
  std::vector<Sym3> diagonal() const;
  /// The inverses of the diagonal's blocks, 0 where nodes are fixed. Blocks are made a little larger than they
  /// are: f32 knows them to some 10⁻⁷ of their largest part, and their smallest must stay positive.
  std::vector<Sym3> inverse_diagonal() const;
};

/// Part of a block's trace that is added to its diagonal before it is inverted.
inline constexpr double kDiagonalMargin = 4e-6;

/// Calls visit(m, weight, r) for the middle node m of each term of GridBending along i (stride 1) or j (stride nx).
template <class Visit>
void for_each_bend(const GridOperator& grid, bool along_i, const Visit& visit) {
  const GridBending& bending = grid.bending;
  const std::uint32_t n = along_i ? grid.nx : grid.ny, lines = along_i ? grid.ny : grid.nx;
  const double stiffness = along_i ? bending.along_i : bending.along_j;
  if (stiffness == 0) return;
  for (std::uint32_t line = 0; line < lines; ++line) {
    const bool rim = (line == 0 || line + 1 == lines) && !bending.uniform;
    for (std::uint32_t m = 1; m + 1 < n; ++m)
      visit(along_i ? line * grid.nx + m : m * grid.nx + line, rim ? stiffness / 2 : stiffness,
            m + 2 < n ? 1
            : along_i ? bending.last_i
                      : bending.last_j);
  }
}

}  // namespace weft::reference
