// What `bench hanging` and `bench pull` have in common: a row, and how it is filled.
#pragma once

#include <optional>

#include "bench/measure.hpp"
#include "sim/kernel_times.hpp"

namespace weft::bench {

/// What contact left of the cloth after the counted steps.
struct Outcome {
  std::uint32_t crossings = 0;  // edges that pass through the object or the cloth
  double max_stretch = 0;       // length / rest length
};

/// One row of a benchmark: what was run, how long a step took, and the state it reached.
struct Row {
  std::string object;      // "none", "sphere", "armadillo", "dragon"
  std::string variant;     // formulation or contact method
  std::uint32_t side = 0;  // nodes along an edge of the sheet
  std::uint64_t nodes = 0, springs = 0, object_triangles = 0;
  std::uint32_t substeps = 0;  // of a 60 Hz frame, chosen by "auto"
  double dispatches_per_step = 0;
  Timing step;                           // ms a step, over whole submits, queue drained after each
  double real_time_factor = 0;           // simulated seconds per wall second
  double bytes_per_step = 0;             // that the state alone must move: read once, written once
  std::optional<double> start;           // when the counted frames begin, where that is not at rest [s]
  std::uint64_t contacts = 0;            // hits of the counted frames
  std::optional<Outcome> outcome;        // of rows with something to meet
  Timing paper_frame;                    // ms a frame as the paper counts it: time_drawn_frames
  std::uint64_t gpu_bytes = 0;           // that the timed world holds
  std::vector<sim::KernelTime> kernels;  // empty: the adapter has no timestamps
  std::string state_hash;                // after the counted frames, before the timed ones
  std::string skipped;                   // why this row was not run; empty where it was
};

/// A row that says why it was not run; `begun` has its names.
Row skipped_row(Row begun, const std::string& why);
/// The measured row, or `begun` as a skipped one where this adapter cannot run it. Other errors are passed
/// on.
Result<Row> or_skipped(Result<Row> measured, const Row& begun);

/// Of a frame, in a step: searches included, which are recorded in some of them.
double dispatches_per_step(sim::World& world);

/// Adds what stands in every row: sizes, dispatches, bytes.
void describe(Row& row, sim::World& world, std::uint32_t substeps);

/// Sets what a step takes: its time from whole submits, then its kernels; near a `pose`, where there is one.
/// Errors  Diverged, DeviceLost; as sim::World::restore.
Result<void> time_row(Row& row, sim::World& world, double budget_ms, std::uint32_t least_submits,
                      const Pose* pose = nullptr);

}  // namespace weft::bench
