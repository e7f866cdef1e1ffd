// The V-cycle of the multigrid solver. Source: docs/solvers/multigrid.md.
#pragma once

#include "reference/multigrid/transfer.hpp"

namespace weft::reference {

/// The eigenvalues of D⁻¹ A that smoothing is for: the upper end is above all of them, 2 for springs and 8/3
/// for bending inside; the coarsest grid has none below that are left to others.
inline constexpr double kSmoothHigh = 2.9, kSmoothLow = kSmoothHigh / 8, kBottomLow = kSmoothHigh / 30;
inline constexpr int kSmoothDegree = 2, kBottomDegree = 10;

/// Improves A x = r by Chebyshev's polynomial of D⁻¹ A for eigenvalues from `low` to kSmoothHigh.
void smooth(const GridOperator& matrix, const std::vector<Sym3>& inverse_diagonal, const Field& r, Field& x,
            double low, int degree);

/// The levels of one linear system.
class Hierarchy {
 public:
  /// `fine` is the matrix; `source` has the nine-point part whose Pᵀ A P the coarse ones are.
  Hierarchy(GridOperator fine, const GridOperator& source);

  /// One V-cycle for A x = r from x = 0.
  Field cycle(const Field& r) const { return cycle_from(0, r); }
  /// The part of it on one level and all coarser ones.
  Field cycle_from(std::size_t level, const Field& r) const;
  const std::vector<GridOperator>& levels() const { return levels_; }

 private:
  std::vector<GridOperator> levels_;
  std::vector<std::vector<Sym3>> inverse_;
};

}  // namespace weft::reference
