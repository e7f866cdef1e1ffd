#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/world.hpp"

namespace weft::cli {

/// In which frames contact shortened more than one in a thousand ways of vertices, how many an obstacle has
/// passed, by how much cloth was slowed down, and what linear systems were left with.
class Altered {
 public:
  /// `truncated`: how many ways were shortened in this frame.
  void add(const sim::World& world, std::uint32_t frame, std::uint64_t truncated);
  /// A sentence each; none where nothing was altered.
  std::vector<std::string> sentences(const sim::World& world) const;

 private:
  std::uint32_t frames_ = 0, first_ = 0;
  double most_ = 0;
};

}  // namespace weft::cli
