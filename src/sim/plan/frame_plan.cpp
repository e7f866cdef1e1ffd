#include "sim/plan/frame_plan.hpp"

#include <algorithm>

namespace weft::sim {
namespace {

constexpr double kEver = 1e9;  // s; later than any motion begins

}  // namespace

Result<FramePlan> FramePlan::create(const scene::Scene& scene, const Model& model, const Assets& assets) {
  FramePlan plan;
  plan.choice_ = choose_method(scene, model);
  WEFT_CHECK(check_elements(scene, model, plan.method()));
  plan.limit_ = plan.method().step_limit(scene, model);
  plan.frame_time_ = scene.time.frame;
  plan.thickness_ = scene.contact.thickness;
  WEFT_TRY(substeps, choose_substeps(scene, plan.method(), plan.limit_));
  plan.substeps_ = substeps;
  if (scene.contact.method == scene::ContactMethod::Proximity)
    plan.movers_ = contact_movers(scene, model, assets.objects, assets.keyframes);
  plan.most_substeps_ = substeps * contact_step_factor(plan.movers_, plan.thickness_, 0, kEver, plan.step());
  return plan;
}

std::uint32_t FramePlan::substeps_of(std::uint32_t frame) const {
  return substeps_ * contact_step_factor(movers_, thickness_, begin_of(frame), begin_of(frame + 1), step());
}

double FramePlan::step_ratio_of(std::uint32_t frame) const {
  return frame == 0 ? 1 : step_ratio(substeps_of(frame - 1), substeps_of(frame));
}

double FramePlan::fastest_mover(std::uint32_t frame) const {
  const double now = begin_of(frame);
  double speed = 0;
  for (const ContactMover& mover : movers_)
    speed = std::max(speed, largest_speed(mover, now, now + frame_time_));
  return speed;
}

}  // namespace weft::sim
