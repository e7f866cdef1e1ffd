#include "sim/plan/frame_plan.hpp"

#include "contact/rules/rigid_body.hpp"

namespace weft::sim {
namespace {

constexpr double kEver = 1e9;  // s; later than any motion begins

}  // namespace

Result<FramePlan> FramePlan::create(const scene::Scene& scene, const Model& model, const Assets& assets) {
  FramePlan plan;
  const bool meets = scene.contact.method == scene::ContactMethod::Proximity && scene::has_rigid(scene);
  const double lightest =
      meets ? lightest_rigid(solids_of(scene, assets.objects, assets.object_colliders)) : 0;
  WEFT_SET(plan.choice_, choose_method(scene, model, lightest));
  plan.frame_time_ = scene.time.frame;
  plan.thickness_ = scene.contact.thickness;
  if (scene.contact.method == scene::ContactMethod::Proximity)
    plan.movers_ =
        contact_movers(scene, model, assets.objects, assets.deformations, plan.method().holds_obstacles);
  plan.most_substeps_ = plan.substeps_between(0, kEver);
  return plan;
}

FramePlan::Frame FramePlan::frame(std::uint32_t number) const {
  const double speed = mover_speed(number);
  const std::uint32_t substeps = substeps_of(number);
  const double ratio = number == 0 ? 1 : step_ratio(substeps_of(number - 1), substeps);
  return {begin_of(number), substeps, speed, ratio};
}

}  // namespace weft::sim
