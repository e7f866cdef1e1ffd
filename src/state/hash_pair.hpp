#pragma once

#include <cstdint>

namespace weft {

/// The same function as in src/state/hash_pair.wgsl.
constexpr std::uint32_t hash_pair(std::uint32_t a, std::uint32_t b) {
  std::uint32_t h = a * 1664525U + 1013904223U;
  h = (h ^ b) * 2246822519U;
  h = (h ^ (h >> 15U)) * 3266489917U;
  h = (h ^ b) * 668265263U;
  return h ^ (h >> 16U);
}

}  // namespace weft
