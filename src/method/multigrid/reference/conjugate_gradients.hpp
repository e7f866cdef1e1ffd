// Conjugate gradients preconditioned by a V-cycle, stopped by their residual. Source: docs/solvers/multigrid.md,
// equations 13 to 15.
#pragma once

#include <algorithm>
#include <cmath>

#include "method/multigrid/reference/cycle.hpp"
#include "method/multigrid/reference/pair_hold.hpp"
#include "method/multigrid/solve_limits.hpp"

namespace weft::reference {

/// Pairs that are held apart, and which nodes of the cloth are fixed.
struct HeldPairs {
  std::span<const PairHold> holds;
  const std::vector<bool>* fixed = nullptr;
};

struct Solution {
  Field x;
  std::uint32_t iterations = 0;
  double residual = 0;  // its norm over that of the right-hand side
};

inline double inner_product(const Field& a, const Field& b) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += dot(a[n], b[n]);
  return sum;
}

/// Solves A x = r, where A is the matrix and what `pairs` add to it, beginning with the best multiple of `guess`, to a
/// residual of `wanted` of r's in the norm of D⁻¹, and to ten times that of what the guess leaves.
template <class Matrix>
Solution solve(const Cycle<Matrix>& hierarchy, Field r, const Field& guess, double wanted,
               std::uint32_t most_iterations = multigrid::kMostIterations, const HeldPairs& pairs = {}) {
  const Matrix& matrix = hierarchy.levels()[0];
  const std::vector<Sym3>& inverse = hierarchy.inverse_diagonals()[0];
  Solution found{Field(r.size())};
  const auto norm = [&] {
    double square = 0;
    for (std::size_t n = 0; n < r.size(); ++n) square += dot(r[n], inverse[n] * r[n]);
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
  const double first = norm();
  double left = go_along(guess, inner_product(guess, r)), before = 0;
  const double enough = wanted * std::min(first, multigrid::kGuessPart * left);
  Field p(r.size());
  while (left > enough && found.iterations < most_iterations) {
    const Field z = hierarchy.cycle(r);
    const double rho = inner_product(r, z), keep = before > 0 ? rho / before : 0;
    for (std::size_t n = 0; n < p.size(); ++n) p[n] = z[n] + keep * p[n];
    before = rho;
    left = go_along(p, rho);
    ++found.iterations;
  }
  found.residual = first > 0 ? left / first : 0;
  return found;
}

}  // namespace weft::reference
