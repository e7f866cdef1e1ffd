#include "bench/pull.hpp"

#include <cmath>

#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr double kSlowestStepMs = 2000;

struct Case {
  const char* object;
  std::uint32_t side;
  bool quick;
};

Result<scene::Scene> load_case(const Case& c, const Folders& folders) {
  const std::string side = std::to_string(c.side);
  const std::vector<scene::Override> overrides = {{"cloths.0.grid", "[" + side + "," + side + "]"},
                                                  {"time.substeps", "\"auto\""}};
  return scene::load_scene(folders.scenes + "/pull-" + c.object + ".json", overrides);
}

/// The state at which the methods are compared, reached by the tree.
Result<sim::Snapshot> warm_up(gpu::Device& device, scene::Scene scene, const sim::Assets& assets, double seconds) {
  scene.contact.method = scene::ContactMethod::Bvh;
  WEFT_TRY(world, sim::World::create(device, scene, assets));
  const int frames = static_cast<int>(std::ceil(seconds / scene.time.frame));
  for (int frame = 0; frame < frames; ++frame) WEFT_CHECK(world->advance_frame());
  WEFT_CHECK(world->finish());
  return world->snapshot();
}

Result<Row> measure(gpu::Device& device, const Case& c, const scene::Scene& scene, const sim::Assets& assets,
                    const sim::Snapshot& start, scene::ContactMethod method) {
  scene::Scene fixed = scene;
  fixed.contact.method = method;
  const bool brute_force = method == scene::ContactMethod::Paper;
  const std::uint32_t steps = brute_force ? 2 : c.quick ? 8 : 64;
  WEFT_TRY(substeps, fix_step(device, fixed, assets, steps));
  WEFT_TRY(world, sim::World::create(device, fixed, assets));
  world->restore(start);
  WEFT_CHECK(world->advance_frame());
  WEFT_CHECK(world->finish());
  WEFT_TRY(snapshot, world->snapshot());
  Row row = describe(*world, substeps);
  row.object = c.object;
  row.variant = scene::name_of(method);
  row.contacts = world->totals().contacts;
  row.state_hash = snapshot.hash();
  WEFT_TRY(timing, time_steps(*world, c.quick ? 200 : 300, brute_force ? 1 : 5));
  row.ms_per_step = timing.median;
  row.ms_per_step_min = timing.least;
  row.real_time_factor = 1000.0 / 60 / (timing.median * substeps);
  return row;
}

}  // namespace

Result<std::vector<Row>> run_pull(gpu::Device& device, bool quick, const Folders& folders,
                                  const std::function<void(const Row&)>& done) {
  const std::vector<const char*> objects = quick ? std::vector<const char*>{"sphere", "armadillo"}
                                                 : std::vector<const char*>{"sphere", "armadillo", "dragon"};
  const std::vector<std::uint32_t> sides =
      quick ? std::vector<std::uint32_t>{32, 64} : std::vector<std::uint32_t>{64, 100, 128, 256, 400, 800};
  std::vector<Row> rows;
  for (const char* object : objects) {
    bool too_slow = false;
    for (const std::uint32_t side : sides) {
      const Case c{object, side, quick};
      WEFT_TRY(scene, load_case(c, folders));
      WEFT_TRY(assets, sim::load_assets(scene, folders.models));
      WEFT_TRY(start, warm_up(device, scene, assets, quick ? 0.05 : 0.4));
      for (const auto method : {scene::ContactMethod::None, scene::ContactMethod::Bvh, scene::ContactMethod::Paper}) {
        if (method == scene::ContactMethod::Paper && too_slow) {
          Row skipped;
          skipped.object = object;
          skipped.variant = "paper";
          skipped.nodes = static_cast<std::uint64_t>(side) * side;
          skipped.skipped = "the size before took over 2 s a step";
          rows.push_back(skipped);
        } else {
          WEFT_TRY(row, measure(device, c, scene, assets, start, method));
          too_slow = too_slow || row.ms_per_step > kSlowestStepMs;
          rows.push_back(row);
        }
        done(rows.back());
      }
    }
  }
  return rows;
}

}  // namespace weft::bench
