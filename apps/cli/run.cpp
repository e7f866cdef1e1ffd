#include "run.hpp"

#include <chrono>
#include <cstdio>

#include "assets.hpp"
#include "progress.hpp"
#include "run_results.hpp"
#include "summary.hpp"

namespace weft::cli {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The frame at which `fault` strikes, if it is of this kind.
bool strikes(const std::string& fault, const char* kind, std::uint32_t frame) {
  return fault == std::string(kind) + "@" + std::to_string(frame);
}

/// Says in which frames contact shortened more than one in a thousand ways of vertices, how many an obstacle has
/// passed, by how much cloth was slowed down, and what linear systems were left with.
class Altered {
 public:
  void add(const sim::World& world, std::uint32_t frame) {
    const std::uint64_t truncated = world.totals().truncated - truncated_;
    truncated_ = world.totals().truncated;
    const double ways =
        static_cast<double>(world.model().host.vertex_count()) * world.plan().substeps_of(frame);
    const double part = static_cast<double>(truncated) / ways;
    if (part <= kPart) return;
    if (frames_++ == 0) first_ = frame;
    most_ = std::max(most_, part);
  }
  void say_all(const sim::World& world) const {
    if (frames_ > 0)
      say("In %u frames, from frame %u on, contact shortened more than 0.1 %% of the vertices' ways, at most "
          "%.2g %% in a frame, since cloth or an obstacle would have been passed: more substeps help.",
          frames_, first_, 100 * most_);
    if (world.totals().driven > 0)
      say("Obstacles have come past cloth %llu times, since the cloth behind it did not give way.",
          static_cast<unsigned long long>(world.totals().driven));
    const sim::Totals& totals = world.totals();
    if (totals.flattened > 0)
      say("Up to %u of %llu tetrahedra had less than a twentieth of their volume, or were inside out: the "
          "body "
          "is pressed harder than its material bears, or the steps are too long.",
          totals.flattened, static_cast<unsigned long long>(world.model().host.count(ElementKind::Tet)));
    if (totals.slowed > 0)
      say("Cloth was slowed down in %llu substeps, by %.3g ms in all, since it would have "
          "passed through cloth: more substeps help.",
          static_cast<unsigned long long>(totals.slowed), 1e3 * totals.delay_s);
    if (totals.unsolved > 0)
      say("Linear systems of substeps kept more than %g of their residual %llu times, at most %.2g after %u "
          "iteration%s: more substeps help.",
          world.scene().solver.residual, static_cast<unsigned long long>(totals.unsolved),
          static_cast<double>(totals.residual), totals.iterations, totals.iterations == 1 ? "" : "s");
  }

 private:
  static constexpr double kPart = 0.001;
  std::uint64_t truncated_ = 0;
  std::uint32_t frames_ = 0, first_ = 0;
  double most_ = 0;
};

Result<void> simulate(sim::World& world, RunResults* results, const RunOptions& options, Summary& summary,
                      Altered& altered) {
  const std::uint32_t frames = options.frames.value_or(world.scene().time.frames);
  Progress progress("simulating", options.quiet ? 0 : frames);
  bool tangled = false;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    if (interrupted())
      return make_error(ErrorKind::Interrupted, "Interrupted after %u of %u frames.", frame, frames);
    if (strikes(options.fault, "nan", frame)) world.set_node(0, {NAN, 0, 0, 1}, {});
    if (strikes(options.fault, "lost", frame)) world.device().lose();
    const auto start = Clock::now();
    WEFT_CHECK(world.advance_frame());
    WEFT_CHECK(world.finish());
    summary.frame_ms.push_back(milliseconds_since(start));
    if (world.totals().crossings > 0 && !tangled) {
      tangled = true;
      say("Cloth is in a tangle since frame %u: edges pass through triangles at %u places, and contact moves "
          "them apart.",
          frame, world.totals().crossings);
    }
    altered.add(world, frame);
    if (results != nullptr) WEFT_CHECK(results->add_frame(world));
    progress.show(frame + 1, summary.frame_ms.back());
  }
  return {};
}

const char* end_of(const Result<void>& result) {
  if (result) return "complete";
  switch (result.error().kind) {
    case ErrorKind::Interrupted:
      return "interrupted";
    case ErrorKind::Diverged:
      return "diverged";
    default:
      return "failed";
  }
}

/// A frame is one piece of work for the GPU: within it there is no progress to show, and no signal is heard.
void say_if_long(const sim::World& world) {
  constexpr std::uint32_t kMany = 10000;
  if (world.most_substeps() <= kMany) return;
  say("A frame takes up to %u substeps, and may take long: an interrupt is heard at its end, a second one at "
      "once.",
      world.most_substeps());
}

void print_summary(const Summary& summary, const sim::World& world, const RunOptions& options,
                   const RunResults* results) {
  if (options.json) {
    std::fputs(summary_json(summary, world).c_str(), stdout);
  } else if (!options.quiet) {
    std::fputs(summary_text(summary, world).c_str(), stdout);
    if (results != nullptr)
      std::printf("  written     %s: %s\n", options.out.c_str(), results->listed().c_str());
  }
}

Result<void> run_scene(const RunOptions& options) {
  interrupted();
  WEFT_TRY(scene, load(options.scene));
  WEFT_TRY(assets, load_checked_assets(scene));
  gpu::DeviceOptions device_options;
  device_options.adapter = options.adapter;
  WEFT_TRY(device, gpu::Device::create(device_options));
  if (options.frames) scene.time.frames = *options.frames;
  WEFT_TRY(world, sim::World::create(*device, std::move(scene), assets));
  say_if_long(*world);
  const std::string unstable =
      unstable_step(world->plan().limit(), world->scene().time.frame, world->substeps());
  if (!unstable.empty()) say("%s", unstable.c_str());
  std::unique_ptr<RunResults> results;
  if (!options.out.empty()) WEFT_SET(results, RunResults::create(*world, options));

  Summary summary;
  summary.scene = options.scene.path;
  const auto start = Clock::now();
  Altered altered;
  const Result<void> ended = simulate(*world, results.get(), options, summary, altered);
  // After a divergence or an interrupt the device still works, and what was reached is kept.
  if (!ended && ended.error().kind != ErrorKind::Diverged && ended.error().kind != ErrorKind::Interrupted)
    return ended;
  if (results) WEFT_CHECK(results->finish_pictures());
  altered.say_all(*world);
  if (world->totals().crossings_left > 0)
    say("Cloth ends in a tangle: edges pass through triangles at %u places.", world->totals().crossings_left);
  summary.end = end_of(ended);
  summary.wall_s = milliseconds_since(start) / 1000;
  WEFT_TRY(snapshot, world->snapshot());
  summary.state_hash = snapshot.hash();
  if (results) WEFT_CHECK(results->write_end(*world, snapshot, summary));
  print_summary(summary, *world, options, results.get());
  return ended;
}

}  // namespace

int run(const RunOptions& options) {
  const Result<void> result = run_scene(options);
  return result ? 0 : report(result.error());
}

}  // namespace weft::cli
