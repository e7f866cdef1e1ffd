// How a scene is stepped, decided on the host: the same for the GPU and for the reference.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/rules/contact_steps.hpp"
#include "method/method.hpp"
#include "model/assets.hpp"
#include "model/model.hpp"
#include "scene/motion.hpp"
#include "scene/scene.hpp"

namespace weft::sim {

/// The end of a number of frames. In these three numbers and not in one, so that a world that goes on from it with
/// frames of the same length computes the same times to the bit.
struct FrameTime {
  double origin = 0;  // when frame 0 begins [s]
  double length = 0;  // of a frame [s]
  std::uint32_t frame = 0;
  double seconds() const { return origin + frame * length; }
};

/// The method, the substeps of each frame and where things that move are in them. Times in [s].
class FramePlan {
 public:
  FramePlan() = default;
  /// Errors  Input: the method does not take an element. Limit: "auto" needs more substeps than scenes allow.
  static Result<FramePlan> create(const scene::Scene& scene, const Model& model, const Assets& assets);

  const Method& method() const { return *choice_.method; }
  /// Why "auto" took that method; "" where the scene names it.
  const std::string& reason() const { return choice_.reason; }
  const StepLimit& limit() const { return choice_.limit; }
  void set_limit(StepLimit limit) { choice_.limit = std::move(limit); }

  /// Of a frame in which nothing moves fast.
  std::uint32_t substeps() const { return choice_.substeps; }
  double step() const { return frame_time_ / choice_.substeps; }
  /// Of a frame, counted from 0: more than substeps() where something is moved fast (docs/contact.md).
  std::uint32_t substeps_of(std::uint32_t frame) const {
    return substeps_between(begin_of(frame), begin_of(frame + 1));
  }
  /// The most of any frame.
  std::uint32_t most_substeps() const { return most_substeps_; }
  /// How one frame is stepped.
  struct Frame {
    double begin = 0;  // [s]
    std::uint32_t substeps = 1;
    double mover_speed = 0;  // the most that any point of a mover does in it [m/s]
    double step_ratio =
        1;  // its substeps' length by the frame before's; 0: a method with a history starts without it
  };
  Frame frame(std::uint32_t number) const;
  FrameTime time_of(std::uint32_t frame) const { return {origin_, frame_time_, frame}; }
  double begin_of(std::uint32_t frame) const { return time_of(frame).seconds(); }
  /// When a substep of a frame of `count` ends, for motions.
  double end_of(std::uint32_t frame, std::uint32_t substep, std::uint32_t count) const {
    return origin_ + (static_cast<double>(frame) * count + substep + 1) * (frame_time_ / count);
  }
  /// Makes time go on from `time`: returns the number of the frame that begins then.
  std::uint32_t go_on_from(const FrameTime& time) {
    const bool same = time.length == frame_time_;
    origin_ = same ? time.origin : time.seconds();
    return same ? time.frame : 0;
  }

 private:
  double mover_speed(std::uint32_t frame) const {
    return largest_speed(movers_, begin_of(frame), begin_of(frame + 1));
  }
  std::uint32_t substeps_between(double begin, double end) const {
    return choice_.substeps * contact_step_factor(movers_, begin, end, thickness_, step());
  }

  MethodChoice choice_;
  std::vector<ContactMover> movers_;  // where contact looks at places at the start of a substep
  double frame_time_ = 0, thickness_ = 0;
  double origin_ = 0;  // when frame 0 begins
  std::uint32_t most_substeps_ = 1;
};

}  // namespace weft::sim
