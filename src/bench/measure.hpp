#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim/world.hpp"

namespace weft::bench {

/// What repeated work took [ms].
struct Timing {
  double median = 0, least = 0;
  double low = 0, high = 0;  // 5 of 100 took less than `low`, 5 more than `high`: this run's own noise
  std::uint32_t samples = 0;
};

/// All zeros if there are no times.
Timing timing_of(std::vector<double> milliseconds);

/// A state that timed frames stay near: repeats simulate seconds, in which a scene comes to rest.
struct Pose {
  sim::Snapshot state;
  double until = 0;  // no frame ends later, but for the first two [s]
};
/// Puts a world of the pose's scene there and runs its first frame, after which lists are long enough.
/// Errors  as sim::World::restore and advance_frame.
Result<void> begin_at(const Pose& pose, sim::World& world);
/// Begins there again if the next frame would end after the pose.
Result<void> stay_near(const Pose& pose, sim::World& world);

/// Does `work` until `budget_ms` are spent, `least` times or more. A time is that of one of its `parts`. `prepare` is
/// done before each, and not timed.
Result<Timing> time_repeats(double budget_ms, std::uint32_t least, double parts,
                            const std::function<Result<void>()>& work,
                            const std::function<Result<void>()>& prepare = {});

/// Whether an error leaves out a row only: what is too large for the adapter, or did not stay finite.
bool skips_row(const Error& error);

/// Runs frames, drained after each, until `budget_ms` are spent; at least `least_frames`. With a `pose` it stays near.
Result<Timing> time_steps(sim::World& world, double budget_ms, std::uint32_t least_frames,
                          const Pose* pose = nullptr);

/// The substeps of a frame of this scene: its own, or what "auto" chooses. Errors  Input, Limit.
Result<std::uint32_t> count_substeps(const scene::Scene& scene, const Assets& assets);

/// Sets the scene to `steps` substeps a frame with the step that "auto" chooses for a frame of 1/60 s.
/// Returns the substeps of a 60 Hz frame. Errors  Limit, DeviceLost.
Result<std::uint32_t> fix_step(scene::Scene& scene, const Assets& assets, std::uint32_t steps);

}  // namespace weft::bench
