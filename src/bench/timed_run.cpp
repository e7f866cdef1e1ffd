#include "bench/timed_run.hpp"

#include <chrono>
#include <numeric>

#include "bench/row.hpp"

namespace weft::bench {
namespace {

constexpr int kWarmUpFrames = 2;
constexpr std::size_t kLeastFrames = 8;  // before a run is known to take too long
constexpr std::uint32_t kKernelRepeats = 5;

Result<void> run_frame(sim::World& world) {
  WEFT_CHECK(world.advance_frame());
  return world.finish();
}

Result<void> check_time(const std::vector<double>& times, const Measuring& measuring) {
  if (!measuring.most_ms || times.size() < kLeastFrames) return {};
  const double median = timing_of(times).median;
  if (median <= *measuring.most_ms) return {};
  return make_error(ErrorKind::Limit, "Frames take %.3g ms, more than the %.3g asked for.", median,
                    *measuring.most_ms);
}

}  // namespace

Result<TimedRun> run_timed(gpu::Device& device, const scene::Scene& scene, const Assets& assets,
                           std::span<const std::uint32_t> stops, const Measuring& measuring) {
  using Clock = std::chrono::steady_clock;
  TimedRun run;
  const std::uint64_t before = device.allocated_bytes();
  WEFT_TRY(world, sim::World::create(device, scene, assets));
  for (int frame = 0; frame < kWarmUpFrames; ++frame) WEFT_CHECK(run_frame(*world));
  WEFT_CHECK(world->reset());
  WEFT_CHECK(device.wait());
  std::vector<double> times;
  for (const std::uint32_t stop : stops) {
    while (world->frame() < stop) {
      const auto start = Clock::now();
      WEFT_CHECK(run_frame(*world));
      times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      WEFT_CHECK(check_time(times, measuring));
    }
    WEFT_TRY(state, world->snapshot());
    run.states.push_back(std::move(state));
  }
  run.solver = world->plan().method().kind;
  run.substeps = world->substeps();
  run.dispatches_per_step = dispatches_per_step(*world);
  run.real_time_factor = 1000 * world->time() / std::accumulate(times.begin(), times.end(), 0.0);
  run.frame = timing_of(std::move(times));
  run.totals = world->totals();
  run.gpu_bytes = device.allocated_bytes() - before;
  if (!measuring.kernels) return run;
  WEFT_TRY(kernels, sim::time_kernels(*world, kKernelRepeats));
  run.kernels = std::move(kernels);
  return run;
}

}  // namespace weft::bench
