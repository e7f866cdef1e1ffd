#include "bench/largest_side.hpp"

#include <algorithm>
#include <cmath>

namespace weft::bench {
namespace {

constexpr double kMostGrowth = 8;  // from try to try, so that what the next one takes can be foreseen

}  // namespace

Result<LargestSide> find_largest_side(std::uint32_t first, std::uint32_t beyond, std::uint64_t limit,
                                      const std::function<Result<Trial>(std::uint32_t side)>& attempt) {
  WEFT_TRY(start, attempt(first));
  if (start.outcome != Trial::Outcome::Fits)
    return make_error(ErrorKind::Limit, "Not even %u nodes a side fit: %s", first, start.why.c_str());
  LargestSide found{first};
  std::uint64_t bytes = start.bytes;  // at found.side
  std::uint32_t refusals = 0;         // in a row
  while (beyond - found.side > 1) {
    const double side = found.side;
    const double reaches = side * std::sqrt(static_cast<double>(limit) / static_cast<double>(bytes));
    // A buffer has a row or a block more or less than the square: its part of the whole is 1 / side.
    const double guess = refusals > 1 ? 0.5 * (side + beyond) : reaches * (1 - 1 / side);
    const auto next =
        static_cast<std::uint32_t>(std::clamp(std::min(guess, kMostGrowth * side), side + 1, beyond - 1.0));
    WEFT_TRY(trial, attempt(next));
    if (trial.outcome == Trial::Outcome::Untried) {
      found.side = static_cast<std::uint32_t>(std::clamp(guess, side, beyond - 1.0));
      found.untried = trial.why;
      return found;
    }
    refusals = trial.outcome == Trial::Outcome::Refused ? refusals + 1 : 0;
    if (refusals > 0) {
      beyond = next;
      found.refusal = trial.why;
    } else {
      found.side = next;
      bytes = trial.bytes;
    }
  }
  return found;
}

}  // namespace weft::bench
