#include "bench/timed_run.hpp"

#include <chrono>
#include <numeric>

#include "bench/row.hpp"

namespace weft::bench {
namespace {

constexpr int kWarmUpFrames = 2;
constexpr std::uint32_t kKernelRepeats = 5;

Result<void> run_frame(sim::World& world) {
  WEFT_CHECK(world.advance_frame());
  return world.finish();
}

}  // namespace

Result<TimedRun> run_timed(gpu::Device& device, const scene::Scene& scene, const Assets& assets,
                           std::span<const std::uint32_t> stops) {
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
    }
    WEFT_TRY(state, world->snapshot());
    run.states.push_back(std::move(state));
  }
  run.substeps = world->substeps();
  run.dispatches_per_step = dispatches_per_step(*world);
  run.real_time_factor = 1000 * world->time() / std::accumulate(times.begin(), times.end(), 0.0);
  run.frame = timing_of(std::move(times));
  run.totals = world->totals();
  run.gpu_bytes = device.allocated_bytes() - before;
  WEFT_TRY(kernels, sim::time_kernels(*world, kKernelRepeats));
  run.kernels = std::move(kernels);
  return run;
}

}  // namespace weft::bench
