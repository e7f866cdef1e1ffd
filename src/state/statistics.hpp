#pragma once

#include <cstddef>
#include <cstdint>

namespace weft {

/// Mirror of shaders/shared/statistics.wgsl: what a frame reports.
struct Statistics {
  std::uint32_t hits = 0;
  std::uint32_t hit_hash = 0;
  float max_stretch = 0;  // length / rest length
  std::uint32_t contact_overflow = 0;
  std::uint32_t nonfinite = 0;
  std::uint32_t frozen = 0;
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(Statistics) == 32);
inline constexpr std::uint32_t kStatisticsPerFrameBytes = 16;  // the part that is cleared before each frame
static_assert(kStatisticsPerFrameBytes == offsetof(Statistics, nonfinite), "what is kept comes last");

/// The same function as in the shader.
constexpr std::uint32_t hash_pair(std::uint32_t a, std::uint32_t b) {
  std::uint32_t h = a * 1664525U + 1013904223U;
  h = (h ^ b) * 2246822519U;
  h = (h ^ (h >> 15U)) * 3266489917U;
  h = (h ^ b) * 668265263U;
  return h ^ (h >> 16U);
}

}  // namespace weft
