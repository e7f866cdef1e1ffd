// What a search for pairs costs.
#pragma once

#include <cstdint>
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

}  // namespace weft::bench
