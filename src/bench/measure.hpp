#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/world.hpp"

namespace weft::bench {

/// One row of a benchmark: what was run, how long a step took, and the state it reached.
struct Row {
  std::string object;   // "none", "sphere", "armadillo", "dragon"
  std::string variant;  // formulation or contact method
  std::uint64_t nodes = 0, springs = 0, object_triangles = 0;
  std::uint32_t substeps = 0;  // of a 60 Hz frame, chosen by "auto"
  double dispatches_per_step = 0;
  double ms_per_step = 0;  // median over the timed submits, queue drained
  double ms_per_step_min = 0;
  double real_time_factor = 0;  // simulated seconds per wall second
  double bytes_per_step = 0;    // that the state alone must move: read once, written once
  std::uint64_t contacts = 0;   // hits of the counted frames
  std::string state_hash;       // after the counted frames, before the timed ones
  std::string skipped;          // why this row was not run; empty where it was
};

struct Timing {
  double median = 0, least = 0;  // ms
};

/// Does `work` until `budget_ms` are spent, `least` times or more. A time is that of one of its `parts`.
Result<Timing> time_repeats(double budget_ms, std::uint32_t least, double parts,
                            const std::function<Result<void>()>& work);

/// Runs frames, drained after each, until `budget_ms` are spent; at least `least_frames`.
Result<Timing> time_steps(sim::World& world, double budget_ms, std::uint32_t least_frames);

/// Sets the scene to `steps` substeps a frame with the step that "auto" chooses for a frame of 1/60 s.
/// Returns the substeps of a 60 Hz frame. Errors  Limit, DeviceLost.
Result<std::uint32_t> fix_step(scene::Scene& scene, const sim::Assets& assets, std::uint32_t steps);

/// What stands in every row: sizes, dispatches, bytes.
Row describe(sim::World& world, std::uint32_t substeps);

}  // namespace weft::bench
