#include "run.hpp"

#include <chrono>
#include <cstdio>

#include "assets.hpp"
#include "scene_run.hpp"

namespace weft::cli {
namespace {

const char* end_of(const Result<void>& result) {
  if (result) return "complete";
  return result.error().kind == ErrorKind::Interrupted ? "interrupted" : "diverged";
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

Result<void> simulate(SceneRun& run) {
  for (;;) {
    const Result<void> ended = run.simulate();
    if (ended || ended.error().kind != ErrorKind::DeviceLost || !run.can_go_back()) return ended;
    WEFT_CHECK(run.go_back());
  }
}

Result<void> run_scene(const RunOptions& options) {
  interrupted();
  WEFT_TRY(scene, load(options.scene));
  WEFT_TRY(assets, load_checked_assets(scene));
  SceneRun run(options, std::move(scene), std::move(assets));
  WEFT_CHECK(run.begin());
  const auto start = std::chrono::steady_clock::now();
  const Result<void> ended = simulate(run);
  if (!ended && ended.error().kind != ErrorKind::Diverged && ended.error().kind != ErrorKind::Interrupted)
    return ended;
  sim::World& world = run.world();
  for (const std::string& sentence : run.altered().sentences(world)) say("%s", sentence.c_str());
  if (world.totals().crossings_left > 0)
    say("Cloth ends in a tangle: edges pass through triangles at %u places.", world.totals().crossings_left);
  Summary& summary = run.summary();
  summary.scene = options.scene.path;
  summary.end = end_of(ended);
  summary.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  WEFT_TRY(snapshot, world.snapshot());
  summary.state_hash = snapshot.hash();
  if (run.results() != nullptr) WEFT_CHECK(run.results()->write_end(world, snapshot, summary));
  print_summary(summary, world, options, run.results());
  return ended;
}

}  // namespace

int run(const RunOptions& options) {
  const Result<void> result = run_scene(options);
  return result ? 0 : report(result.error());
}

}  // namespace weft::cli
