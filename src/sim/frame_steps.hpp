// The parameters of a frame's substeps.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.hpp"
#include "scene/wind.hpp"
#include "sim/grabs.hpp"
#include "state/state.hpp"

namespace weft::sim {

/// The blocks of a frame's substeps. They go to the GPU again only where something in them has changed;
/// the host's copy is kept, so that a frame allocates nothing.
class FrameSteps {
 public:
  FrameSteps() = default;
  /// `blocks`: of the most substeps of a frame, with what no frame changes: nodes, contact, method. `frame` [s].
  FrameSteps(std::vector<StepBlock> blocks, double frame);

  /// Takes over gravity, external force, drag and wind, from `time` [s] on. The waves of the wind go on from
  /// where they are.
  void set_air(const scene::Scene& scene, double time);
  /// A frame: when it begins [s] and its substeps.
  struct Frame {
    double time = 0;
    std::uint32_t substeps = 1;
    double collider_speed = 0;  // the largest in it [m/s]
    double step_ratio = 1;      // of its first step to the one before
  };
  void write(gpu::Device& device, const gpu::Buffer<StepBlock>& steps, const Grabs& grabs,
             const Frame& frame);
  /// Restarts time at 0.
  void rewind();

 private:
  double turns(std::size_t wave, double time) const {
    return start_turns_[wave] + wind_.waves[wave].rate * (time - start_);
  }

  std::vector<StepBlock> blocks_;
  scene::WindField wind_;
  double frame_ = 0;                        // [s]
  double start_ = 0;                        // when the wind became what it is [s]
  std::array<double, 2> start_turns_ = {};  // of its waves, then
  bool changed_ = true;
  std::uint32_t substeps_ = 0;
  double collider_speed_ = 0;
  double step_ratio_ = 1;
  bool held_ = false;  // in the frame that was written last
};

}  // namespace weft::sim
