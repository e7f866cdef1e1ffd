#pragma once

#include <cstddef>
#include <cstdint>

namespace weft {

/// Mirror of src/state/statistics.wgsl: the report of a frame.
struct Statistics {
  std::uint32_t hits = 0;
  std::uint32_t hit_hash = 0;
  float max_stretch = 0;  // length / rest length
  std::uint32_t contact_overflow = 0;
  // By proximity:
  std::uint32_t detections = 0;
  std::uint32_t crossings = 0;   // edges through triangles, the most of any detection
  std::uint32_t truncated = 0;   // vertices truncated by contact, summed over substeps
  std::uint32_t pairs = 0;       // listed by the last detection, or what ought to be
  std::uint32_t candidates = 0;  // the same
  std::uint32_t entries = 0;
  // Kept from frame to frame:
  std::uint32_t nonfinite = 0;
  std::uint32_t frozen = 0;
  std::uint32_t rolled_back = 0;  // 1: a list was too short, and the state is as before the frame
  std::uint32_t detect = 0, due = 0, found = 0;  // the GPU's own
  float reach = 0, travel = 0;                   // the same
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(Statistics) == 80);
inline constexpr std::uint32_t kStatisticsPerFrameBytes = 40;  // the part that is cleared before each frame
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
