#include "sim/world.hpp"

#include <array>

#include "scene/difference.hpp"
#include "scene/motion.hpp"

namespace weft::sim {

Result<std::unique_ptr<World>> World::create(gpu::Device& device, scene::Scene scene, const Assets& assets,
                                             const WorldOptions& options) {
  auto world = std::unique_ptr<World>(new World(device, std::move(scene)));
  WEFT_CHECK(world->build(assets, options));
  return world;
}

Result<void> World::count_contacts(bool on) {
  if (contact_.counts() == nullptr || on == contact_.counting()) return {};
  recorder_.forget();
  WEFT_CHECK(contact_.count(device_, on));
  if (!on) return {};
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "count contacts");
    contact_.record_counts(pass);  // of the state that is shown now
  }
  return device_.submit(list);
}

Result<void> World::submit_rest() {
  gpu::CommandList list;
  contact_.record_rest(list);
  last_good_->record_rigid(list);
  {
    gpu::ComputePass pass(list, "rest");
    last_good_->record(pass);  // the state to restore if the first frame is not finite
    surface_->record(pass);    // so that the rest state can be drawn
  }
  return device_.submit(list);
}

Result<void> World::submit_surface() {
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "surface");
    pass.set_step(0, parity_);
    surface_->record(pass);
  }
  return device_.submit(list);
}

void World::write_motions(std::uint32_t substeps) {
  const auto& motions = model_.host.motions;
  if (motions.empty()) return;
  Vec4f* row = motion_rows_.data();
  for (std::uint32_t s = 0; s < substeps; ++s) {
    const double time = plan_.end_of(frame_, s, substeps);
    for (const scene::Motion& motion : motions) {
      const scene::RigidTransform transform = scene::motion_at(motion, time);
      for (int axis = 0; axis < 3; ++axis) {
        const double* r = &transform.rotation[3 * axis];
        *row++ = {static_cast<float>(r[0]), static_cast<float>(r[1]), static_cast<float>(r[2]),
                  static_cast<float>(transform.translation[axis])};
      }
    }
  }
  state_.motions.write(device_, std::span(motion_rows_).first(3 * motions.size() * substeps));
}

Result<void> World::advance_frame(const gpu::CommandList* draw) {
  const std::uint32_t drawn_parity = parity_after();  // of what `draw` shows
  ++asked_;
  WEFT_CHECK(take_reports(false));
  while (!has_room()) {
    device_.poll();
    WEFT_CHECK(take_reports(false));
  }
  while (frame_ < asked_ && has_room()) {
    const bool shown = frame_ + 1 == asked_ && parity_after_frames(1) == drawn_parity;
    WEFT_CHECK(submit_frame(shown ? draw : nullptr));
  }
  return {};
}

Result<void> World::submit_frame(const gpu::CommandList* draw) {
  const FramePlan::Frame frame = plan_.frame(frame_);
  const std::uint32_t substeps = frame.substeps;
  steps_.write(device_, model_, state_, *grabs_, frame);
  write_motions(substeps);
  contact_.write_places(device_, scene_, frame.begin, scene_.time.frame / substeps, substeps);
  const std::array<const gpu::CommandList*, 3> lists = {&recorder_.commands(parity_, substeps),
                                                        &reports_.commands(), draw};
  WEFT_CHECK(device_.submit(std::span(lists).first(draw != nullptr ? 3 : 2)));
  reports_.expect(frame_, attempt_, parity_);
  parity_ = (parity_ + recorder_.turns_of(substeps)) & 1U;
  ++frame_;
  return {};
}

Result<void> World::poll() {
  WEFT_CHECK(take_reports(false));
  while (frame_ < asked_ && has_room()) WEFT_CHECK(submit_frame(nullptr));
  return {};
}

Result<void> World::repeat_from(const Report& report) {
  parity_ = report.parity;
  frame_ = report.frame;
  ++attempt_;
  ++totals_.repeated_frames;
  WEFT_CHECK(contact_.make_room(
      device_, state_, {report.statistics.pairs, report.statistics.near, report.statistics.candidates}));
  WEFT_CHECK(solver_->bind_lists());
  contact_.adapt(report.statistics);
  solver_->adapt(device_, report.statistics);
  recorder_.forget();
  clear_statistics();
  gpu::CommandList list;
  contact_.record_forget(list);
  last_good_->record_restore(list, state_, parity_);
  return device_.submit(list);
}

void World::clear_statistics() const {
  const std::array<std::uint32_t, sizeof(Statistics) / 4> zeros{};
  state_.statistics.write(device_, zeros);
}

std::uint32_t World::parity_after_frames(std::uint32_t count) const {
  std::uint32_t parity = parity_;
  for (std::uint32_t frame = frame_; frame < frame_ + count; ++frame)
    parity += recorder_.turns_of(plan_.substeps_of(frame));
  return parity & 1U;
}

Result<void> World::finish() {
  do {
    WEFT_CHECK(poll());
    WEFT_CHECK(device_.wait());
    WEFT_CHECK(take_reports(true));
  } while (frame_ < asked_);
  if (diverged_) return *diverged_;  // also where every report of it has been taken already
  return {};
}

Result<void> World::take_reports(bool wait_for_all) {
  device_.poll();
  for (;;) {
    WEFT_TRY(report, reports_.take(device_, wait_for_all));
    if (!report) return {};
    WEFT_CHECK(take(*report));
  }
}

Result<void> World::take(const Report& report) {
  const Statistics& statistics = report.statistics;
  if (report.attempt != attempt_) return {};  // of a frame that is being repeated
  if (statistics.rolled_back != 0) return repeat_from(report);
  if (statistics.nonfinite != 0) {
    totals_.nonfinite = statistics.nonfinite;
    if (!diverged_) {  // the frames after the first bad one say the same
      bad_frame_ = report.frame;
      diverged_ =
          make_error(ErrorKind::Diverged,
                     "In frame %u the state of %u of %u nodes is not finite; the state is frozen as it "
                     "was before that frame.",
                     report.frame, statistics.nonfinite, model_.vertex_count());
    }
    return *diverged_;
  }
  ++totals_.frames;
  last_report_ = statistics;
  add(totals_, statistics);
  if (told_) told_(report.frame);
  const bool contact_adapts = contact_.adapt(statistics);
  if (solver_->adapt(device_, statistics) || contact_adapts) recorder_.forget();
  return {};
}

Result<void> World::reset() {
  WEFT_CHECK(device_.wait());
  reports_.drop();  // they are about discarded frames
  state_.reset(device_, model_.host);
  for (scene::Motion& motion : model_.host.motions)
    if (auto* given = std::get_if<scene::MotionGiven>(&motion.shape)) *given = {given->speed};
  for (const std::size_t collider : given_colliders()) set_ways(collider, {});
  clear_statistics();
  steps_.rewind();
  grabs_->release_all();
  frame_ = asked_ = plan_.go_on_from({});
  parity_ = 0;
  totals_ = {};
  diverged_.reset();
  return submit_rest();
}

Result<void> World::grab(std::uint32_t node, const Vec3d& target) {
  return grabs_->grab(node, target, time());
}
Result<void> World::drag(std::uint32_t node, const Vec3d& target) { return grabs_->drag(node, target); }
Result<void> World::release(std::uint32_t node) { return grabs_->release(node); }

Result<void> World::change(const scene::Scene& scene) {
  if (const auto key = scene::fixed_difference(scene_, scene))
    return input_error("%s cannot change while the cloth moves; load the scene again.", key->c_str());
  StepLimit limit = plan_.method().with_drag(plan_.limit(), scene.drag);
  // A step that a scene chose beyond its own limit is its affair; only a new drag is judged.
  if (scene.drag != scene_.drag && limit.largest_step > 0 && step() > limit.largest_step)
    return make_error(ErrorKind::Limit,
                      "With a drag of %g 1/s the largest stable step is %.4g s, less than the running one of "
                      "%.4g s; load the scene again.",
                      scene.drag, limit.largest_step, step());
  plan_.set_limit(std::move(limit));
  scene_.content = scene.content;
  scene_.gravity = scene.gravity;
  scene_.external_force = scene.external_force;
  scene_.drag = scene.drag;
  scene_.wind = scene.wind;
  scene_.air = scene.air;
  scene_.title = scene.title;
  scene_.description = scene.description;
  scene_.time.frames = scene.time.frames;
  scene_.camera = scene.camera;
  scene_.render = scene.render;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    scene_.cloths[c].color = model_.host.bodies[c].color = scene.cloths[c].color;
    scene_.cloths[c].look = model_.host.bodies[c].look = scene.cloths[c].look;
  }
  for (std::size_t c = 0; c < scene.colliders.size(); ++c)
    scene::set_material(scene_.colliders[c], scene::material_of(scene.colliders[c]));
  steps_.set_air(scene_, time());
  return {};
}

void World::set_node(std::uint32_t node, const Vec4f& position, const Vec4f& given_velocity) {
  const Vec4f velocity = Vec4f::from(given_velocity.xyz(), 0);
  state_.position[parity_].write(device_, std::span(&position, 1), node);
  state_.velocity[parity_].write(device_, std::span(&velocity, 1), node);
  last_good_->renew(device_, std::span(&position, 1), std::span(&velocity, 1), node);
}

}  // namespace weft::sim
