// The time of each kernel in a world's frame.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/world.hpp"

namespace weft::sim {

/// The total time of a kernel's dispatches.
struct KernelTime {
  std::string kernel;     // "find_candidates"
  std::string per;        // "search", "step" or "frame"
  double dispatches = 0;  // a half where one is for two steps
  double milliseconds = 0;
};

/// Runs a frame of two substeps, the first of which searches, with a pass and a pair of timestamps for each
/// dispatch; medians over `repeats` of them. The state goes on by as many frames. Empty where the adapter has
/// no timestamps. Errors  DeviceLost.
Result<std::vector<KernelTime>> time_kernels(World& world, std::uint32_t repeats);

}  // namespace weft::sim
