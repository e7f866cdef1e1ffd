// Seeded random numbers with the same sequence on every machine (std's distributions promise none).
#pragma once

#include <cstdint>

namespace weft {

/// PCG32 (O'Neill 2014, pcg-random.org: XSH-RR output, 64-bit state).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed + kIncrement) { next(); }

  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + kIncrement;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
  }
  /// An integer in [0, count).
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * count) >> 32U);
  }
  /// A number in [low, high), a multiple of (high - low) / 2^24.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 8U) / 16777216.0);
  }

 private:
  static constexpr std::uint64_t kIncrement = 1442695040888963407ULL;
  std::uint64_t state_;
};

}  // namespace weft
