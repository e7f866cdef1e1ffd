#include "bench/search_times.hpp"

#include <cstddef>

#include "gpu/readback.hpp"

namespace weft::bench {
namespace {

using gpu::Command, gpu::CommandKind;

/// A frame of two substeps.
const gpu::CommandList& two_steps(sim::World& world) { return world.frame_commands(world.parity(), 2); }

/// What the first substep does before it searches: a search needs to know where vertices come.
Result<void> predict(sim::World& world) {
  const gpu::CommandList& frame = two_steps(world);
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "prediction");
    for (std::size_t at = 0; at < frame.commands().size() && frame.phase_of(at) != "search"; ++at)
      if (frame.phase_of(at) == "step" && frame.commands()[at].kind == CommandKind::Dispatch)
        pass.repeat(frame, frame.commands()[at]);
  }
  return world.device().submit(list);
}

}  // namespace

std::vector<Command> search_dispatches(sim::World& world) {
  const gpu::CommandList& frame = two_steps(world);
  std::vector<Command> search;
  for (std::size_t at = 0; at < frame.commands().size(); ++at) {
    if (frame.phase_of(at) != "search") {
      if (!search.empty()) break;  // of the first substep alone
    } else if (frame.commands()[at].kind == CommandKind::Dispatch) {
      search.push_back(frame.commands()[at]);
    }
  }
  return search;
}

Result<SearchCost> time_search(sim::World& world, const Effort& effort) {
  WEFT_CHECK(predict(world));
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "searches");
    const std::vector<Command> dispatches = search_dispatches(world);
    for (std::uint32_t k = 0; k < effort.searches; ++k)
      for (const Command& dispatch : dispatches) pass.repeat(two_steps(world), dispatch);
  }
  WEFT_TRY(timing,
           time_repeats(effort.budget_ms, effort.least_submits, effort.searches, [&]() -> Result<void> {
             WEFT_CHECK(world.device().submit(list));
             return world.device().wait();
           }));
  WEFT_TRY(words, gpu::download(world.device(), world.state().statistics));
  const auto read = [&](std::size_t offset) { return words[offset / sizeof(std::uint32_t)]; };
  if (read(offsetof(Statistics, rolled_back)) != 0)
    return make_error(ErrorKind::Limit, "A list was too short while searches were timed.");
  return SearchCost{timing, read(offsetof(Statistics, pairs)), read(offsetof(Statistics, candidates))};
}

}  // namespace weft::bench
