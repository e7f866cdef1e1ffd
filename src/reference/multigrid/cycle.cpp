#include "reference/multigrid/cycle.hpp"

#include <utility>

namespace weft::reference {
namespace {

Field residual(const GridOperator& matrix, const Field& r, const Field& x) {
  Field left = matrix.apply(x);
  for (std::size_t a = 0; a < left.size(); ++a) left[a] = r[a] - left[a];
  return left;
}

}  // namespace

void smooth(const GridOperator& matrix, const std::vector<Sym3>& inverse_diagonal, const Field& r, Field& x,
            double low, int degree) {
  const double middle = (kSmoothHigh + low) / 2, half = (kSmoothHigh - low) / 2, sigma = middle / half;
  double rho = 1 / sigma;
  Field left = residual(matrix, r, x), d(x.size());
  for (int k = 0; k < degree; ++k) {
    double keep = 0, take = 1 / middle;
    if (k > 0) {
      const double next = 1 / (2 * sigma - rho);
      keep = next * rho;
      take = 2 * next / half;
      rho = next;
      left = residual(matrix, r, x);
    }
    for (std::size_t a = 0; a < x.size(); ++a) d[a] = keep * d[a] + take * (inverse_diagonal[a] * left[a]);
    for (std::size_t a = 0; a < x.size(); ++a) x[a] += d[a];
  }
}

Hierarchy::Hierarchy(GridOperator fine, const GridOperator& source) {
  const std::vector<GridLevel> levels = grid_levels(fine.nx, fine.ny);
  const GridBending bending = fine.bending;
  levels_.push_back(std::move(fine));
  for (std::size_t l = 1; l < levels.size(); ++l)
    levels_.push_back(coarsened(l == 1 ? source : levels_.back(), levels[l], bending));
  for (const GridOperator& level : levels_) inverse_.push_back(level.inverse_diagonal());
}

Field Hierarchy::cycle_from(std::size_t level, const Field& r) const {
  const GridOperator& matrix = levels_[level];
  Field x(r.size());
  const bool last = level + 1 == levels_.size();
  if (last && level > 0) {
    smooth(matrix, inverse_[level], r, x, kBottomLow, kBottomDegree);
    return x;
  }
  smooth(matrix, inverse_[level], r, x, kSmoothLow, kSmoothDegree);
  if (last) {  // the only one
    smooth(matrix, inverse_[level], r, x, kSmoothLow, kSmoothDegree);
    return x;
  }
  const Field coarse = cycle_from(level + 1, restricted(residual(matrix, r, x), matrix));
  const Field correction = prolonged(coarse, matrix);
  for (std::size_t a = 0; a < x.size(); ++a) x[a] += correction[a];
  smooth(matrix, inverse_[level], r, x, kSmoothLow, kSmoothDegree);
  return x;
}

}  // namespace weft::reference
