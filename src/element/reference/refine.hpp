// Finer steps and triangles until a number no longer changes. Source: docs/elements.md, The reference.
#pragma once

#include <functional>

#include "base/result.hpp"

namespace weft::reference {

struct Refined {
  double value = 0;  // at the last level
  double error = 0;  // that it has at most, by the order seen, with a quarter more
  double order = 0;  // of the last three levels
  int levels = 0;
};

/// `value` gives the number by a level, which halves all sizes and steps of the level before. Levels 0, 1, 2 … are
/// taken until the error is below `tolerance`. With d and D as the last two changes, the order is p = log2(D/d) and the
/// error 1.25 d/(2^p - 1), where p counts as 2 if it is more (Roache 1994: the grid convergence index). An order below
/// 1/2 is none yet: too coarse.
/// Errors  Diverged: the last of `most` levels is not good enough. Those of `value`.
Result<Refined> refine(const std::function<Result<double>(int level)>& value, double tolerance, int most = 6);

}  // namespace weft::reference
