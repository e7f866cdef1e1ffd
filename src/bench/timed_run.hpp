#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "sim/kernel_times.hpp"

namespace weft::bench {

/// A scene from its start on, each frame timed by itself.
struct TimedRun {
  std::uint32_t substeps = 0;            // of a frame
  double dispatches_per_step = 0;        // searches included
  Timing frame;                          // ms a frame, queue drained after each; nothing else is in it
  double real_time_factor = 0;           // simulated seconds per wall second of all frames together
  std::vector<sim::Snapshot> states;     // at the stops
  sim::Totals totals;                    // of the timed frames
  std::uint64_t gpu_bytes = 0;           // that its world holds
  std::vector<sim::KernelTime> kernels;  // empty: the adapter has no timestamps
};

/// Runs up to the last of `stops` (numbers of frames, rising). A few frames before the first, then undone,
/// see to it that kernels are compiled. Errors  as sim::World::create and advance_frame.
Result<TimedRun> run_timed(gpu::Device& device, const scene::Scene& scene, const Assets& assets,
                           std::span<const std::uint32_t> stops);

}  // namespace weft::bench
