#include "sim/frame_steps.hpp"

namespace weft::sim {

FrameSteps::FrameSteps(const StepParams& base, std::uint32_t substeps, std::size_t motion_count, double step)
    : steps_(substeps, base), step_(step) {
  for (std::uint32_t s = 0; s < substeps; ++s) {
    steps_[s].first_motion = s * 3 * static_cast<std::uint32_t>(motion_count);
    steps_[s].first_place = s * base.first_place;
    steps_[s].detect = s == 0 ? Detect::Always : s % kDetectInterval == 0 ? Detect::IfDue : Detect::No;
  }
}

void FrameSteps::set_air(const scene::Scene& scene, double time) {
  for (std::size_t wave = 0; wave < start_turns_.size(); ++wave)
    start_turns_[wave] = scene::turn_part(turns(wave, time));
  start_ = time;
  wind_ = scene::wind_field(scene.wind);
  const Vec3d acceleration = scene.gravity + scene.external_force;
  for (StepParams& params : steps_) {
    params.acceleration = Vec4f::from(acceleration.to<float>(), 0);
    params.drag = static_cast<float>(scene.drag);
  }
  changed_ = true;
}

void FrameSteps::write(gpu::Device& device, const gpu::Buffer<StepParams>& steps, const Grabs& grabs,
                       double time, std::uint32_t parity) {
  const bool held = grabs.any(time, time + static_cast<double>(steps_.size()) * step_);
  if (!changed_ && !wind_.varies() && !held && !held_ && parity == parity_) return;
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    const double now = time + static_cast<double>(s) * step_;  // the substep's forces are those at its start
    set_wind(steps_[s], wind_, {turns(0, now), turns(1, now)});
    steps_[s].parity = (parity + static_cast<std::uint32_t>(s)) & 1U;
    grabs.set(steps_[s], now + step_);  // a follower, as a motion, goes to where the target is at the end
  }
  steps.write(device, steps_);
  changed_ = false;
  held_ = held;
  parity_ = parity;
}

void FrameSteps::rewind() {
  start_ = 0;
  start_turns_ = {};
  changed_ = true;
}

}  // namespace weft::sim
