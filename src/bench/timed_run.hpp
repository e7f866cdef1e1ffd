#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "sim/kernel_times.hpp"

namespace weft::bench {

/// A scene from its start on, each frame timed by itself.
struct TimedRun {
  scene::SolverKind solver = {};         // which ran, where the scene says "auto"
  std::uint32_t substeps = 0;            // of a frame
  double dispatches_per_step = 0;        // searches included
  Timing frame;                          // ms a frame, queue drained after each; nothing else is in it
  double real_time_factor = 0;           // simulated seconds per wall second of all frames together
  std::vector<sim::Snapshot> states;     // at the stops
  sim::Totals totals;                    // of the timed frames
  std::uint64_t gpu_bytes = 0;           // that its world holds
  std::vector<sim::KernelTime> kernels;  // empty: not asked for, or the adapter has no timestamps
};

/// What a run is measured by.
struct Measuring {
  bool kernels = true;            // the time of each kernel, after all else
  std::optional<double> most_ms;  // a run whose frames take longer in the median ends after a few of them
};

/// Runs up to the last of `stops` (numbers of frames, rising). A few frames before the first, then undone,
/// see to it that kernels are compiled.
/// Errors  as sim::World::create and advance_frame. Limit: frames take longer than `most_ms`.
Result<TimedRun> run_timed(gpu::Device& device, const scene::Scene& scene, const Assets& assets,
                           std::span<const std::uint32_t> stops, const Measuring& measuring = {});

}  // namespace weft::bench
