#include "sim/frame_steps.hpp"

namespace weft::sim {

FrameSteps::FrameSteps(const StepParams& base, std::uint32_t most_substeps, std::uint32_t interval,
                       std::size_t motion_count, double frame)
    : steps_(most_substeps, base), frame_(frame) {
  for (std::uint32_t s = 0; s < most_substeps; ++s) {
    steps_[s].first_motion = s * 3 * static_cast<std::uint32_t>(motion_count);
    steps_[s].first_place = s * base.first_place;
    steps_[s].detect = s == 0 ? Detect::Always : s % interval == 0 ? Detect::IfDue : Detect::No;
  }
}

void FrameSteps::set_air(const scene::Scene& scene, double time) {
  for (std::size_t wave = 0; wave < start_turns_.size(); ++wave)
    start_turns_[wave] = scene::turn_part(turns(wave, time));
  start_ = time;
  wind_ = scene::wind_field(scene.wind);
  const Vec3d acceleration = scene.gravity + scene.external_force;
  for (StepParams& params : steps_) {
    params.acceleration = Vec4f::from(acceleration.to<float>(), params.acceleration.w);
    params.drag = static_cast<float>(scene.drag);
  }
  changed_ = true;
}

void FrameSteps::write(gpu::Device& device, const gpu::Buffer<StepParams>& steps, const Grabs& grabs,
                       const FramePlan::Frame& frame) {
  const bool grabbed = grabs.any(frame.begin, frame.begin + frame_);
  const bool same =
      frame.substeps == substeps_ && frame.mover_speed == mover_speed_ && frame.step_ratio == step_ratio_;
  if (!changed_ && !wind_.varies() && !grabbed && !grabbed_ && same) return;
  const double step = frame_ / frame.substeps;
  for (std::uint32_t s = 0; s < frame.substeps; ++s) {
    StepParams& params = steps_[s];
    const double now = frame.begin + s * step;  // the substep's forces are those at its start
    params.dt = static_cast<float>(step);
    params.step_ratio = s == 0 ? static_cast<float>(frame.step_ratio) : 1.0F;
    params.acceleration.w = static_cast<float>(frame.mover_speed * step);
    set_wind(params, wind_, {turns(0, now), turns(1, now)});
    grabs.set(params, now + step);  // a follower, as a motion, goes to where the target is at the end
  }
  steps.write(device, std::span(steps_).first(frame.substeps));
  changed_ = false;
  grabbed_ = grabbed;
  substeps_ = frame.substeps;
  mover_speed_ = frame.mover_speed;
  step_ratio_ = frame.step_ratio;
}

void FrameSteps::rewind() {
  start_ = 0;
  start_turns_ = {};
  changed_ = true;
}

}  // namespace weft::sim
