// The parameters of a frame's substeps.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.hpp"
#include "scene/wind.hpp"
#include "sim/grabs.hpp"
#include "sim/plan/frame_plan.hpp"
#include "state/grab_slots.hpp"

namespace weft::sim {

/// The waves of the wind: how many turns each had made at `since` [s], and makes in a second from then on.
struct Gusts {
  double since = 0;
  std::array<double, 2> turns = {}, rates = {};
};

/// The blocks of a frame's substeps. They go to the GPU again only where something in them has changed;
/// the host's copy is kept, so that a frame allocates nothing.
class FrameSteps {
 public:
  FrameSteps() = default;
  /// `blocks`: of the most substeps of a frame, with what no frame changes: nodes, contact, method. `frame` [s].
  FrameSteps(std::vector<StepBlock> blocks, double frame);

  /// Takes over gravity, external force, drag, wind and air, from `time` [s] on. The waves of the wind go on from
  /// where they are.
  void set_air(const scene::Scene& scene, double time);
  void write(gpu::Device& device, const GpuModel& model, const State& state, const Grabs& grabs,
             const FramePlan::Frame& frame);
  Gusts gusts() const;
  /// Makes the waves at `time` [s] those of `gusts`; from then on this wind moves them.
  void set_gusts(const Gusts& gusts, double time);
  /// Restarts time at 0.
  void rewind();

 private:
  double turns(std::size_t wave, double time) const {
    return start_turns_[wave] + wind_.waves[wave].rate * (time - start_);
  }

  std::vector<StepBlock> blocks_;
  scene::WindField wind_;
  double frame_ = 0;                        // [s]
  double start_ = 0;                        // when the wind last changed [s]
  std::array<double, 2> start_turns_ = {};  // of its waves, then
  bool changed_ = true;
  std::uint32_t substeps_ = 0;
  double mover_speed_ = 0;
  double step_ratio_ = 1;
  bool grabbed_ = false;  // in the frame that was written last
  FrameGrabs grabs_;
  GrabSlots slots_;
};

}  // namespace weft::sim
