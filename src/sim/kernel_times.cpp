#include "sim/kernel_times.hpp"

#include <algorithm>
#include <cstddef>

#include "gpu/timer.hpp"

namespace weft::sim {
namespace {

using gpu::Command, gpu::CommandKind;

/// A frame of two substeps.
const gpu::CommandList& two_steps(World& world) { return world.frame_commands(world.parity(), 2); }

/// "find_candidates" of contact/proximity/find_candidates.wgsl.
std::string kernel_name(const gpu::CommandList& list, const Command& dispatch) {
  const std::string& path = list.label(static_cast<std::uint32_t>(dispatch.sizes[0]));
  const std::size_t begin = path.rfind('/') + 1;
  return path.substr(begin, path.rfind('.') - begin);
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Which kernel each dispatch of the two steps counts for.
struct Plan {
  std::vector<KernelTime> kernels;
  std::vector<std::size_t> kernel_of;
};
Plan plan_of(const gpu::CommandList& frame) {
  Plan plan;
  for (std::size_t at = 0; at < frame.commands().size(); ++at) {
    const Command& dispatch = frame.commands()[at];
    if (dispatch.kind != CommandKind::Dispatch) continue;
    const std::string name = kernel_name(frame, dispatch), &per = frame.phase_of(at);
    std::size_t k = 0;
    while (k < plan.kernels.size() && (plan.kernels[k].kernel != name || plan.kernels[k].per != per)) ++k;
    if (k == plan.kernels.size()) plan.kernels.push_back({name, per});
    ++plan.kernels[k].dispatches;
    plan.kernel_of.push_back(k);
  }
  return plan;
}

/// The frame of two steps with a pass and a span for each dispatch.
Result<std::vector<gpu::Timer::Span>> run_timed(World& world, gpu::Timer& timer) {
  gpu::CommandList list;
  const gpu::CommandList& frame = two_steps(world);
  for (const Command& command : frame.commands()) {
    if (command.kind == CommandKind::ClearBuffer)
      list.clear({command.ids[0], gpu::ObjectKind::Buffer, command.sizes[0], command.sizes[1]});
    if (command.kind != CommandKind::Dispatch) continue;
    gpu::ComputePass pass(list, "timed", timer.span(kernel_name(frame, command)));
    pass.repeat(frame, command);
  }
  timer.finish(list);
  WEFT_CHECK(world.device().submit(list));
  return timer.read();
}

}  // namespace

Result<std::vector<KernelTime>> time_kernels(World& world, std::uint32_t repeats) {
  if (!world.device().has_timestamps()) return std::vector<KernelTime>{};
  const gpu::CommandList& frame = two_steps(world);
  Plan plan = plan_of(frame);
  WEFT_TRY(timer, gpu::Timer::create(world.device(), static_cast<std::uint32_t>(plan.kernel_of.size())));
  std::vector<std::vector<double>> times(plan.kernels.size());  // of each kernel, by repeat
  for (std::uint32_t repeat = 0; repeat < repeats; ++repeat) {
    WEFT_TRY(spans, run_timed(world, timer));
    for (std::vector<double>& own : times) own.push_back(0);
    for (std::size_t k = 0; k < spans.size(); ++k) times[plan.kernel_of[k]].back() += spans[k].milliseconds;
  }
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    KernelTime& kernel = plan.kernels[k];
    kernel.milliseconds = median_of(times[k]);
    const double times_run = kernel.per == "step" ? 2 : static_cast<double>(frame.phase_count(kernel.per));
    kernel.milliseconds /= times_run;
    kernel.dispatches /= times_run;
  }
  return plan.kernels;
}

}  // namespace weft::sim
