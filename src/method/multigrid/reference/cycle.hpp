// The V-cycle of the multigrid solver, for grids and for meshes. Source: docs/solvers/multigrid.md.
#pragma once

#include <utility>

#include "method/multigrid/bottom.hpp"
#include "method/multigrid/reference/mesh_operator.hpp"
#include "method/multigrid/reference/transfer.hpp"

namespace weft::reference {

using multigrid::Bottom, multigrid::Smoothing, multigrid::kSmoothHigh;

/// r - A x
template <class Matrix>
Field residual(const Matrix& matrix, const Field& r, const Field& x) {
  Field left = matrix.apply(x);
  for (std::size_t a = 0; a < left.size(); ++a) left[a] = r[a] - left[a];
  return left;
}

/// Improves A x = r by Chebyshev's polynomial of D⁻¹ A.
template <class Matrix>
void smooth(const Matrix& matrix, const std::vector<Sym3>& inverse_diagonal, const Field& r, Field& x,
            const Smoothing& smoothing) {
  Field d(x.size());
  for (std::uint32_t k = 0; k < smoothing.sweeps; ++k) {
    const auto [keep, take] = multigrid::sweep_of(smoothing, k);
    const Field left = residual(matrix, r, x);
    for (std::size_t a = 0; a < x.size(); ++a) d[a] = keep * d[a] + take * (inverse_diagonal[a] * left[a]);
    for (std::size_t a = 0; a < x.size(); ++a) x[a] += d[a];
  }
}

/// The levels of one linear system, the finest first.
template <class Matrix>
class Cycle {
 public:
  /// One V-cycle for A x = r from x = 0.
  Field cycle(const Field& r) const { return cycle_from(0, r); }
  /// The part of it on one level and all coarser ones.
  Field cycle_from(std::size_t level, const Field& r) const {
    const Matrix& matrix = levels_[level];
    Field x(r.size());
    const bool last = level + 1 == levels_.size();
    if (last && level > 0) {
      smooth(matrix, inverse_[level], r, x, {bottom_.sweeps, bottom_.low, kSmoothHigh});
      return x;
    }
    const Smoothing smoothing = level == 0 ? finest_ : Smoothing{};
    smooth(matrix, inverse_[level], r, x, smoothing);
    if (!last) {
      const Field coarse = cycle_from(level + 1, restricted(residual(matrix, r, x), matrix));
      const Field correction = prolonged(coarse, matrix);
      for (std::size_t a = 0; a < x.size(); ++a) x[a] += correction[a];
    }
    smooth(matrix, inverse_[level], r, x, smoothing);
    return x;
  }
  const std::vector<Matrix>& levels() const { return levels_; }
  const std::vector<std::vector<Sym3>>& inverse_diagonals() const { return inverse_; }

 protected:
  Cycle(const Bottom& bottom, const Smoothing& finest) : bottom_(bottom), finest_(finest) {}
  void add(Matrix matrix) {
    inverse_.push_back(matrix.inverse_diagonal());
    levels_.push_back(std::move(matrix));
  }

 private:
  Bottom bottom_;
  Smoothing finest_;
  std::vector<Matrix> levels_;
  std::vector<std::vector<Sym3>> inverse_;
};

/// Of a grid.
class Hierarchy : public Cycle<GridOperator> {
 public:
  /// `fine` is the matrix; `source` has the nine-point part whose Pᵀ A P the coarse ones are.
  /// `finest`: the smoothing of that level.
  Hierarchy(GridOperator fine, const GridOperator& source, const Bottom& bottom = {},
            const Smoothing& finest = {});
};

/// Of a mesh.
class MeshHierarchy : public Cycle<MeshOperator> {
 public:
  /// `fine` is the matrix; it names its levels, which must stay.
  explicit MeshHierarchy(MeshOperator fine, const Bottom& bottom = {}, const Smoothing& finest = {});
};

}  // namespace weft::reference
