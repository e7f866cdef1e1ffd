#include "sim/world.hpp"

#include <algorithm>

#include "base/state_hash.hpp"
#include "contact/rules/contact_law.hpp"
#include "scene/difference.hpp"
#include "scene/motion.hpp"
#include "method/registry.hpp"

namespace weft::sim {

std::string Snapshot::hash() const {
  return state_hash(std::as_bytes(std::span(position)), std::as_bytes(std::span(velocity)));
}

Result<std::unique_ptr<World>> World::create(gpu::Device& device, scene::Scene scene, const Assets& assets,
                                             const WorldOptions& options) {
  auto world = std::unique_ptr<World>(new World(device, std::move(scene)));
  WEFT_CHECK(world->build(assets, options));
  return world;
}

Result<void> World::create_counter() {
  WEFT_TRY(counter, contact::ContactCounts::create(device_, *contacts_->pairs, contact_counts_));
  counter_ = std::move(counter);
  return {};
}

Result<void> World::count_contacts(bool on) {
  if (!proximity_ || on == counter_.has_value()) return {};
  frame_commands_.clear();
  counter_.reset();
  if (!on) return {};
  WEFT_CHECK(create_counter());
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "count contacts");
    counter_->record(pass);  // of the state that is shown now
  }
  return device_.submit(list);
}

Result<void> World::submit_rest() {
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "rest");
    last_good_->record(pass);  // what a first frame that is not finite goes back to
    surface_->record(pass);    // so that the rest state can be drawn
  }
  return device_.submit(list);
}

StepParams World::base_params() const {
  StepParams params;
  params.dt = static_cast<float>(step());
  params.vertex_count = model_.vertex_count();
  params.spring_count = constants_.spring_count;
  params.force_scale = constants_.force_scale;
  params.force_limit = constants_.force_limit;
  params.thickness = static_cast<float>(scene_.contact.thickness);
  if (collision_) {
    params.push_scale = collision_->push_scale();
    params.max_push = collision_->max_push();
  }
  if (proximity_) {
    const contact::ProximityLengths& lengths = proximity_->lengths();
    params.self_thickness = static_cast<float>(lengths.self_thickness);
    params.least_reach = static_cast<float>(lengths.least_reach);
    params.most_reach = static_cast<float>(lengths.most_reach);
    params.contact_damping = static_cast<float>(contact_damping(scene_.contact.restitution));
    params.point_count = proximity_->search().colliders().point_count;
    params.first_place = static_cast<std::uint32_t>(scene_.colliders.size());
  }
  return params;
}

void World::write_motions(std::uint32_t substeps) {
  const auto& motions = model_.host.motions;
  if (motions.empty()) return;
  Vec4f* row = motion_rows_.data();
  const double step = scene_.time.frame / substeps;
  for (std::uint32_t s = 0; s < substeps; ++s) {
    const double time = (static_cast<double>(frame_) * substeps + s + 1) * step;
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

std::uint32_t World::substeps_of(std::uint32_t frame) const {
  return substeps_ * contact_step_factor(movers_, scene_.contact.thickness, frame * scene_.time.frame,
                                         (frame + 1) * scene_.time.frame, step());
}

void World::record_frame(gpu::CommandList& list, std::uint32_t parity, std::uint32_t substeps) const {
  list.clear(state_.statistics.range(0, kStatisticsPerFrameBytes));
  gpu::ComputePass pass(list, "frame");
  for (std::uint32_t s = 0, turns = 0; s < substeps; ++turns) {
    pass.set_step(s, (parity + turns) & 1U);
    if (solver_->takes_two() && s + 1 < substeps) {
      solver_->record_two(pass);
      s += 2;
      continue;
    }
    if (proximity_) proximity_->record_search(pass);
    solver_->record_predict(pass);
    if (collision_) collision_->record(pass);
    if (proximity_) proximity_->record_evaluate(pass);
    solver_->record_solve(pass);
    ++s;
  }
  pass.set_step(0, (parity + turns_of(substeps)) & 1U);
  last_good_->record(pass);
  surface_->record(pass);
  if (counter_) counter_->record(pass);
}

const gpu::CommandList& World::frame_commands(std::uint32_t parity, std::uint32_t substeps) {
  gpu::CommandList& list = frame_commands_[substeps][parity];
  if (list.commands().empty()) record_frame(list, parity, substeps);
  return list;
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
  Report& free = *std::find_if(reports_.begin(), reports_.end(),
                               [](const Report& report) { return !report.readback.pending(); });
  const double now = frame_ * scene_.time.frame;
  const std::uint32_t substeps = substeps_of(frame_);
  double speed = 0;
  for (const ContactMover& mover : movers_)
    speed = std::max(speed, largest_speed(mover, now, now + scene_.time.frame));
  const double ratio = frame_ == 0 ? 1 : step_ratio(substeps_of(frame_ - 1), substeps);
  steps_.write(device_, state_.steps, *grabs_, {now, substeps, speed, ratio});
  write_motions(substeps);
  if (proximity_) proximity_->write_places(device_, scene_, now, scene_.time.frame / substeps, substeps);
  const std::array<const gpu::CommandList*, 3> lists = {&frame_commands(parity_, substeps), &free.commands,
                                                        draw};
  WEFT_CHECK(device_.submit(std::span(lists).first(draw != nullptr ? 3 : 2)));
  free.frame = frame_;
  free.parity = parity_;
  free.attempt = attempt_;
  free.readback.start();
  parity_ = (parity_ + turns_of(substeps)) & 1U;
  ++frame_;
  return {};
}

Result<void> World::poll() {
  WEFT_CHECK(take_reports(false));
  while (frame_ < asked_ && has_room()) WEFT_CHECK(submit_frame(nullptr));
  return {};
}

Result<void> World::repeat_from(const Report& report, const Statistics& short_of) {
  parity_ = report.parity;
  frame_ = report.frame;
  ++attempt_;
  ++totals_.repeated_frames;
  ContactPairs& pairs = *contacts_->pairs;
  const ContactRoom room =
      grown(pairs.room, {short_of.pairs, short_of.candidates}, device_.limits().max_storage_binding_size);
  WEFT_CHECK(pairs.make_room(device_, room));
  WEFT_CHECK(proximity_->bind_lists(device_, state_, pairs));
  WEFT_CHECK(solver_->bind_lists(state_, pairs));
  if (counter_) WEFT_CHECK(create_counter());
  frame_commands_.clear();
  const std::array<std::uint32_t, sizeof(Statistics) / 4> zeros{};
  state_.statistics.write(device_, zeros);
  gpu::CommandList list;
  list.clear(pairs.vertex_contacts.source());
  if (pairs.presses.size() > 0) list.clear(pairs.presses.source());
  last_good_->record_restore(list, state_, parity_);
  return device_.submit(list);
}

std::uint32_t World::parity_after_frames(std::uint32_t count) const {
  std::uint32_t parity = parity_;
  for (std::uint32_t frame = frame_; frame < frame_ + count; ++frame) parity += turns_of(substeps_of(frame));
  return parity & 1U;
}

bool World::has_room() const {
  return std::any_of(reports_.begin(), reports_.end(),
                     [](const Report& report) { return !report.readback.pending(); });
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
  // In the order of their frames, so that the first bad one is the one that is named.
  std::array<Report*, 3> order = {&reports_[0], &reports_[1], &reports_[2]};
  std::sort(order.begin(), order.end(), [](const Report* a, const Report* b) { return a->frame < b->frame; });
  for (Report* report : order) {
    if (!report->readback.pending()) continue;
    while (wait_for_all && !report->readback.ready() && !report->readback.failed()) device_.poll();
    if (report->readback.ready() || report->readback.failed()) WEFT_CHECK(take(*report));
  }
  return {};
}

Result<void> World::take(Report& report) {
  const bool failed = report.readback.failed();
  Statistics statistics;
  report.readback.take(std::as_writable_bytes(std::span(&statistics, 1)));
  if (failed) {
    WEFT_CHECK(device_.status());
    return make_error(ErrorKind::DeviceLost, "The report of frame %u did not arrive.", report.frame);
  }
  if (report.attempt != attempt_) return {};  // of a frame that is being repeated
  if (statistics.held != 0) return repeat_from(report, statistics);
  totals_.nonfinite = statistics.nonfinite;
  if (statistics.nonfinite != 0) {
    if (!diverged_)  // the frames after the first bad one say the same
      diverged_ =
          make_error(ErrorKind::Diverged,
                     "In frame %u the state of %u of %u nodes is not finite; the state is frozen as it "
                     "was before that frame.",
                     report.frame, statistics.nonfinite, model_.vertex_count());
    return *diverged_;
  }
  ++totals_.frames;
  totals_.contacts += statistics.hits;
  totals_.contact_hash += statistics.hit_hash;
  totals_.contact_overflow += statistics.contact_overflow;
  totals_.detections += statistics.detections;
  totals_.crossings = std::max(totals_.crossings, statistics.crossings);
  totals_.crossings_left = statistics.found;
  totals_.truncated += statistics.truncated;
  totals_.pairs = std::max(totals_.pairs, statistics.pairs);
  totals_.candidates = std::max(totals_.candidates, statistics.candidates);
  totals_.max_stretch = std::max(totals_.max_stretch, statistics.max_stretch);
  return {};
}

Result<void> World::reset() {
  WEFT_CHECK(device_.wait());
  for (Report& report : reports_)  // what they would say is of no more use
    if (report.readback.pending()) report.readback.take();
  state_.reset(device_, model_.host);
  const std::array<std::uint32_t, sizeof(Statistics) / 4> zeros{};
  state_.statistics.write(device_, zeros);
  steps_.rewind();
  grabs_->release_all();
  frame_ = asked_ = 0;
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
    return input_error("%s cannot change while the cloth moves; load the scene anew.", key->c_str());
  StepLimit limit = with_drag(choice_.kind, limit_, scene.drag);
  // A step that a scene chose beyond its own limit is its affair; only a new drag is judged.
  if (scene.drag != scene_.drag && limit.largest_step > 0 && step() > limit.largest_step)
    return make_error(ErrorKind::Limit,
                      "With a drag of %g 1/s the largest stable step is %.4g s, less than the running one of "
                      "%.4g s; load the scene anew.",
                      scene.drag, limit.largest_step, step());
  limit_ = std::move(limit);
  scene_.gravity = scene.gravity;
  scene_.external_force = scene.external_force;
  scene_.drag = scene.drag;
  scene_.wind = scene.wind;
  scene_.title = scene.title;
  scene_.description = scene.description;
  scene_.time.frames = scene.time.frames;
  scene_.camera = scene.camera;
  scene_.render = scene.render;
  steps_.set_air(scene_, time());
  return {};
}

Result<Snapshot> World::snapshot() {
  Snapshot snapshot;
  WEFT_TRY(position, gpu::download(device_, state_.position[parity_]));
  snapshot.position = std::move(position);
  WEFT_TRY(velocity, gpu::download(device_, state_.velocity[parity_]));
  snapshot.velocity = std::move(velocity);
  return snapshot;
}

void World::restore(const Snapshot& snapshot) {
  std::vector<Vec4f> velocity = snapshot.velocity;
  for (Vec4f& v : velocity) v.w = 0;  // what the step before it was is not in the snapshot
  state_.position[parity_].write(device_, snapshot.position);
  state_.velocity[parity_].write(device_, velocity);
  last_good_->renew(device_, snapshot.position, velocity, 0);
}

void World::set_node(std::uint32_t node, const Vec4f& position, const Vec4f& given_velocity) {
  const Vec4f velocity = Vec4f::from(given_velocity.xyz(), 0);
  state_.position[parity_].write(device_, std::span(&position, 1), node);
  state_.velocity[parity_].write(device_, std::span(&velocity, 1), node);
  last_good_->renew(device_, std::span(&position, 1), std::span(&velocity, 1), node);
}

}  // namespace weft::sim
