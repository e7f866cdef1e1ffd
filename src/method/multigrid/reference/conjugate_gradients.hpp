// Conjugate gradients preconditioned by a V-cycle, stopped by their residual. Source: docs/solvers/multigrid.md,
// equations 13 to 15.
#pragma once

#include <algorithm>
#include <cmath>

#include "method/multigrid/reference/cycle.hpp"
#include "method/multigrid/reference/pair_hold.hpp"
#include "method/multigrid/solve_limits.hpp"

namespace weft::reference {

/// Pairs that are held apart, which nodes of the cloth are fixed, and what a node's part of a norm counts; none: 1.
struct HeldPairs {
  std::span<const PairHold> holds;
  const std::vector<bool>* fixed = nullptr;
  std::span<const float> norm_scales{};
};

struct Solution {
  Field x;
  std::uint32_t iterations = 0;
  double first = 0;  // norm of the right-hand side
  double guess = 0;  // of what the guess has left
  double left = 0;   // of what is left
};

inline double inner_product(const Field& a, const Field& b) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += dot(a[n], b[n]);
  return sum;
}

/// Of norms, what counts as solved for a wanted part of them: of r's, and ten times that of what the guess leaves.
inline double enough_of(const Solution& solution, double wanted) {
  return wanted * std::min(solution.first, multigrid::kGuessPart * solution.guess);
}

/// Solves A x = r, where A is the matrix and what `pairs` add to it, beginning with the best multiple of `guess`, until
/// the norm of what is left, that of D⁻¹, is enough(solution) or less.
template <class Matrix, class Enough>
Solution solve(const Cycle<Matrix>& hierarchy, Field r, const Field& guess, std::uint32_t most_iterations,
               const HeldPairs& pairs, const Enough& enough) {
  const Matrix& matrix = hierarchy.levels()[0];
  const std::vector<Sym3>& inverse = hierarchy.inverse_diagonals()[0];
  Solution found{Field(r.size())};
  const auto norm = [&] {
    double square = 0;
    for (std::size_t n = 0; n < r.size(); ++n)
      square += (pairs.norm_scales.empty() ? 1 : pairs.norm_scales[n]) * dot(r[n], inverse[n] * r[n]);
    return std::sqrt(square);
  };
  const auto go_along = [&](const Field& p, double rho) {
    Field q = matrix.apply(p);
    for (const PairHold& pair : pairs.holds) pair.add_product(p, q, *pairs.fixed);
    const double square = inner_product(p, q), rate = square > 0 ? rho / square : 0;
    for (std::size_t n = 0; n < p.size(); ++n) {
      found.x[n] += rate * p[n];
      r[n] -= rate * q[n];
    }
    return norm();
  };
  found.first = norm();
  found.guess = found.left = go_along(guess, inner_product(guess, r));
  double before = 0;
  const double most = enough(found);
  Field p(r.size());
  while (found.left > most && found.iterations < most_iterations) {
    const Field z = hierarchy.cycle(r);
    const double rho = inner_product(r, z), keep = before > 0 ? rho / before : 0;
    for (std::size_t n = 0; n < p.size(); ++n) p[n] = z[n] + keep * p[n];
    before = rho;
    found.left = go_along(p, rho);
    ++found.iterations;
  }
  return found;
}

}  // namespace weft::reference
