#include "scene_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "checkpoint.hpp"
#include "common.hpp"
#include "progress.hpp"
#include "sim/mesh_change.hpp"

namespace weft::cli {
namespace {

/// A frame is one piece of work for the GPU: within it there is no progress to show, and no signal is heard.
void say_if_long(const sim::World& world) {
  constexpr std::uint32_t kMany = 10000;
  if (world.most_substeps() <= kMany) return;
  say("A frame takes up to %u substeps, and may take long: an interrupt is heard at its end, a second one at "
      "once.",
      world.most_substeps());
}

}  // namespace

Result<void> SceneRun::make_world() {
  gpu::DeviceOptions options;
  options.adapter = options_.adapter;
  WEFT_SET(device_, gpu::Device::create(options));
  WEFT_SET(world_, sim::World::create(*device_, scene_, assets_));
  return {};
}

Result<void> SceneRun::change_mesh() {
  WEFT_TRY(change, sim::change_mesh(world_, build_name(),
                                    [this] { return results_ ? results_->settle() : Result<void>(); }));
  for (const std::string& news : change.news) say("%s", news.c_str());
  return change.changed && results_ ? results_->go_on(*world_) : Result<void>();
}

Result<void> SceneRun::begin() {
  if (options_.frames) scene_.time.frames = *options_.frames;
  WEFT_CHECK(make_world());
  if (!options_.resume.empty()) WEFT_CHECK(resume());
  say_if_long(*world_);
  const std::string unstable =
      unstable_step(world_->plan().limit(), world_->scene().time.frame, world_->substeps());
  if (!unstable.empty()) say("%s", unstable.c_str());
  if (!options_.out.empty()) WEFT_SET(results_, RunResults::create(*world_, options_));
  return {};
}

Result<void> SceneRun::resume() {
  auto opened = [&]() -> Result<sim::SavedState> {
    WEFT_TRY(state, read_checkpoint(options_.resume, *world_));
    WEFT_CHECK(sim::open_in(world_, state));
    return state;
  }();
  if (!opened) return opened.error().while_doing("resuming from " + options_.resume);
  sim::SavedState read = std::move(*opened);
  if (const std::string other = other_origin(read, *world_); !other.empty()) say("%s", other.c_str());
  summary_.resumed_frames = furthest_ = read.snapshot.time.frame;
  tangled_ = read.totals.crossings > 0;
  checkpoint_ = std::move(read);
  return {};
}

Result<void> SceneRun::go_back() {
  gone_back_to_ = checkpoint_->snapshot.time.frame;
  say("The GPU device was lost after %u frames; the run goes on from its checkpoint after %u.", furthest_,
      checkpoint_->snapshot.time.frame);
  if (results_) results_->let_go();
  world_.reset();
  WEFT_CHECK(make_world());
  WEFT_CHECK(sim::open_in(world_, *checkpoint_));
  return results_ ? results_->go_on(*world_) : Result<void>();
}

bool SceneRun::strikes(const char* kind, std::uint32_t frame) {
  const auto fault =
      std::find(faults_.begin(), faults_.end(), std::string(kind) + "@" + std::to_string(frame));
  if (fault == faults_.end()) return false;
  faults_.erase(fault);
  return true;
}

Result<void> SceneRun::advance() {
  using Clock = std::chrono::steady_clock;
  const std::uint32_t frame = world_->frame();
  const std::uint64_t truncated = world_->totals().truncated;
  if (strikes("nan", frame)) world_->set_node(0, {NAN, 0, 0, 1}, {});
  if (strikes("lost", frame)) world_->device().lose();
  const auto start = Clock::now();
  WEFT_CHECK(change_mesh());
  WEFT_CHECK(world_->advance_frame());
  WEFT_CHECK(world_->finish());
  if (frame < furthest_) return {};  // it has been counted
  furthest_ = frame + 1;
  summary_.frame_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  altered_.add(*world_, frame, world_->totals().truncated - truncated);
  if (world_->totals().crossings == 0 || tangled_) return {};
  tangled_ = true;
  say("Cloth is in a tangle since frame %u: edges pass through triangles at %u places, and contact moves "
      "them apart.",
      frame, world_->totals().crossings);
  return {};
}

Result<void> SceneRun::keep_checkpoint() {
  if (checkpoint_ && checkpoint_->snapshot.time.frame == world_->frame()) return {};  // it is written
  WEFT_SET(checkpoint_, world_->save(build_name()));
  return results_->write_checkpoint(*checkpoint_);
}

Result<void> SceneRun::simulate_frames() {
  const std::uint32_t frames = scene_.time.frames;
  Progress progress("simulating", options_.quiet ? 0 : frames);
  while (world_->frame() < frames) {
    if (interrupted())
      return make_error(ErrorKind::Interrupted, "Interrupted after %u of %u frames.", world_->frame(),
                        frames);
    WEFT_CHECK(advance());
    if (results_) WEFT_CHECK(results_->add_frame(*world_));
    const bool due = options_.checkpoint_every > 0 && world_->frame() % options_.checkpoint_every == 0;
    if (due) WEFT_CHECK(keep_checkpoint());
    progress.show(world_->frame(), summary_.frame_ms.empty() ? 0 : summary_.frame_ms.back());
  }
  return {};
}

Result<void> SceneRun::simulate() {
  const Result<void> ended = simulate_frames();
  const bool can_go_on = ended || ended.error().kind == ErrorKind::Interrupted;
  if (can_go_on && options_.checkpoint_every > 0) WEFT_CHECK(keep_checkpoint());
  // After a divergence or an interrupt the device still works, and what was reached is kept.
  const bool keeps = can_go_on || ended.error().kind == ErrorKind::Diverged;
  if (keeps && results_) WEFT_CHECK(results_->finish_pictures());
  return ended;
}

}  // namespace weft::cli
