#include "bench/measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "model/attachments.hpp"
#include "sim/plan/frame_plan.hpp"

namespace weft::bench {

Timing timing_of(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return {};
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::size_t count = milliseconds.size();
  const auto at = [&](double part) {
    return milliseconds[static_cast<std::size_t>(std::lround(part * static_cast<double>(count - 1)))];
  };
  return {milliseconds[count / 2], milliseconds.front(), at(0.05), at(0.95),
          static_cast<std::uint32_t>(count)};
}

Result<void> begin_at(const Pose& pose, sim::World& world) {
  WEFT_CHECK(world.restore(pose.state));
  WEFT_CHECK(world.advance_frame());
  return world.finish();
}

Result<void> stay_near(const Pose& pose, sim::World& world) {
  return world.time() + world.scene().time.frame > pose.until ? begin_at(pose, world) : Result<void>();
}

Result<Timing> time_repeats(double budget_ms, std::uint32_t least, double parts,
                            const std::function<Result<void>()>& work,
                            const std::function<Result<void>()>& prepare) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  double spent = 0;
  while (times.size() < least || spent < budget_ms) {
    if (prepare) WEFT_CHECK(prepare());
    const auto start = Clock::now();
    WEFT_CHECK(work());
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    spent += milliseconds;
    times.push_back(milliseconds / parts);
  }
  return timing_of(std::move(times));
}

bool skips_row(const Error& error) {
  return error.kind == ErrorKind::Limit || error.kind == ErrorKind::OutOfMemory ||
         error.kind == ErrorKind::Diverged;
}

Result<Timing> time_steps(sim::World& world, double budget_ms, std::uint32_t least_frames, const Pose* pose) {
  const auto frame = [&]() -> Result<void> {
    WEFT_CHECK(world.advance_frame());
    return world.finish();
  };
  const auto prepare = [&] { return pose != nullptr ? stay_near(*pose, world) : Result<void>(); };
  // A card that has idled, an H100 at 345 MHz, takes tenths of a second to clock up.
  constexpr double kClockUpMs = 300;
  if (world.device().adapter().type != "CPU" && least_frames > 1)
    WEFT_CHECK(time_repeats(kClockUpMs, 1, world.substeps(), frame, prepare));
  return time_repeats(budget_ms, least_frames, world.substeps(), frame, prepare);
}

Result<std::uint32_t> count_substeps(const scene::Scene& scene, const Assets& assets) {
  WEFT_TRY(model, build_model(scene, assets));
  WEFT_TRY(plan, sim::FramePlan::create(scene, model, assets));
  return plan.substeps();
}

Result<std::uint32_t> fix_step(scene::Scene& scene, const Assets& assets, std::uint32_t steps) {
  scene.time.frame = 1.0 / 60;
  scene.time.substeps.reset();
  WEFT_TRY(substeps, count_substeps(scene, assets));
  scene.time.frame = steps * (1.0 / 60) / substeps;
  scene.time.substeps = steps;
  return substeps;
}

}  // namespace weft::bench
