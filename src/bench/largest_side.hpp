#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "base/result.hpp"

namespace weft::bench {

/// What a try at a size has shown.
struct Trial {
  enum class Outcome {
    Fits,
    Refused,
    Untried,  // it would take too much of something else to see
  };
  Outcome outcome = Outcome::Fits;
  std::uint64_t bytes = 0;  // of the largest buffer, where it fits
  std::string why;          // else
};

struct LargestSide {
  std::uint32_t side = 0;  // the largest that fits: the next was refused; where it was not tried, about that
  std::string refusal;     // of the next
  std::string untried;     // why it is not known exactly; empty where it is
};

/// The largest side that fits, where buffers grow as its square and none may exceed `limit` bytes. Each next
/// side to try is guessed from the largest buffer so far; halving takes over where the guess is wrong, so any
/// predicate that goes from fitting to refused once will do.
/// Errors  those of `attempt`. Limit: not even the first side fits.
Result<LargestSide> find_largest_side(std::uint32_t first, std::uint32_t beyond, std::uint64_t limit,
                                      const std::function<Result<Trial>(std::uint32_t side)>& attempt);

}  // namespace weft::bench
