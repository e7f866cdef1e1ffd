#include "sim/frame_steps.hpp"

#include "contact/rules/contact_law.hpp"

namespace weft::sim {

FrameSteps::FrameSteps(std::vector<StepBlock> blocks, double frame)
    : blocks_(std::move(blocks)), frame_(frame) {}

void FrameSteps::set_air(const scene::Scene& scene, double time) {
  for (std::size_t wave = 0; wave < start_turns_.size(); ++wave)
    start_turns_[wave] = scene::turn_part(turns(wave, time));
  start_ = time;
  wind_ = scene::wind_field(scene.wind);
  const Vec3d acceleration = scene.gravity + scene.external_force;
  for (StepBlock& block : blocks_) {
    block.air.acceleration = Vec4f::from(acceleration.to<float>(), 0);
    block.air.drag = static_cast<float>(scene.drag);
    weft::set_air(block.air, scene.air);
  }
  changed_ = true;
}

void FrameSteps::write(gpu::Device& device, const GpuModel& model, const State& state, const Grabs& grabs,
                       const FramePlan::Frame& frame) {
  const bool grabbed = grabs.any(frame.begin, frame.begin + frame_);
  const bool same =
      frame.substeps == substeps_ && frame.mover_speed == mover_speed_ && frame.step_ratio == step_ratio_;
  if (!changed_ && !wind_.varies() && !grabbed && !grabbed_ && same) return;
  const double step = frame_ / frame.substeps;
  grabs.find(frame.begin, frame.begin + frame_, grabs_);
  slots_.set(device, model, grabs_.nodes, grabs_.still.size());
  for (std::uint32_t s = 0; s < frame.substeps; ++s) {
    StepBlock& block = blocks_[s];
    const double now = frame.begin + s * step;  // the substep's forces are those at its start
    block.time = {static_cast<float>(step), s == 0 ? static_cast<float>(frame.step_ratio) : 1.0F};
    block.contact.collider_travel = static_cast<float>(frame.mover_speed * step);
    block.contact.most_delay = most_delay(frame_, step);
    set_wind(block.air, wind_, {turns(0, now), turns(1, now)});
    // a follower, as a motion, goes to where the target is at the end
    grabs.append_goals(grabs_, now + step);
    grabs.fill(block.hands, step);
    slots_.fill(block.hands, state, s);
  }
  GrabSlots::write_goals(device, state, grabs_.still, grabs_.moving);
  state.steps.write(device, std::span(blocks_).first(frame.substeps));
  changed_ = false;
  grabbed_ = grabbed;
  substeps_ = frame.substeps;
  mover_speed_ = frame.mover_speed;
  step_ratio_ = frame.step_ratio;
}

Gusts FrameSteps::gusts() const { return {start_, start_turns_, {wind_.waves[0].rate, wind_.waves[1].rate}}; }

void FrameSteps::set_gusts(const Gusts& gusts, double time) {
  start_ = gusts.since;
  start_turns_ = gusts.turns;
  changed_ = true;
  if (gusts.rates == std::array{wind_.waves[0].rate, wind_.waves[1].rate}) return;  // to the bit
  for (std::size_t wave = 0; wave < start_turns_.size(); ++wave)
    start_turns_[wave] = scene::turn_part(gusts.turns[wave] + gusts.rates[wave] * (time - gusts.since));
  start_ = time;
}

void FrameSteps::rewind() {
  start_ = 0;
  start_turns_ = {};
  changed_ = true;
}

}  // namespace weft::sim
