// A world's frame taken apart: what a search for pairs costs, and each kernel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "gpu/command_list.hpp"

namespace weft::bench {

/// The dispatches of one search for pairs: what a substep that may search has over one that may not. Empty
/// where the method does not search, or does in every substep.
std::vector<gpu::Command> search_dispatches(sim::World& world);

/// How much is run to measure something.
struct Effort {
  std::uint32_t steps = 0, searches = 0;  // of a submit
  double budget_ms = 0;
  std::uint32_t least_submits = 0;
};

/// What a search takes, and what it lists.
struct SearchCost {
  Timing timing;  // ms
  std::uint32_t pairs = 0, candidates = 0;
};

/// Searches anew and anew in the state at the end of the last frame, which stays as it is.
/// Errors  Limit: a list is too short for what there is to find. DeviceLost.
Result<SearchCost> time_search(sim::World& world, const Effort& effort);

/// What the dispatches of a kernel took together.
struct KernelTime {
  std::string kernel;     // "find_candidates"
  std::string per;        // "search", "step" or "frame"
  double dispatches = 0;  // a half where one is for two steps
  double milliseconds = 0;
};

/// Runs a frame of two substeps, the first of which searches, with a pass and a pair of timestamps for each
/// dispatch; medians over `repeats` of them. The state goes on by as many frames. Empty where the adapter has
/// no timestamps. Errors  DeviceLost.
Result<std::vector<KernelTime>> time_kernels(sim::World& world, std::uint32_t repeats);

}  // namespace weft::bench
