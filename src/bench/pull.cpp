#include "bench/pull.hpp"

#include <cmath>

#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr double kSlowestStepMs = 2000;
constexpr std::uint32_t kCountedSteps =
    2;  // the same for all methods, so that contacts and hashes can be compared

/// How contact is found; names stand in results.
struct Variant {
  const char* name;
  scene::ContactMethod method;
  bool self = false;
};
constexpr Variant kVariants[] = {{"none", scene::ContactMethod::None},
                                 {"bvh", scene::ContactMethod::Bvh},
                                 {"proximity", scene::ContactMethod::Proximity},
                                 {"proximity_self", scene::ContactMethod::Proximity, true},
                                 {"paper", scene::ContactMethod::Paper}};

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

/// The state at which the methods are compared, reached by proximity.
Result<sim::Snapshot> warm_up(gpu::Device& device, scene::Scene scene, const sim::Assets& assets,
                              double seconds) {
  scene.contact.method = scene::ContactMethod::Proximity;
  WEFT_TRY(world, sim::World::create(device, scene, assets));
  const int frames = static_cast<int>(std::ceil(seconds / scene.time.frame));
  for (int frame = 0; frame < frames; ++frame) WEFT_CHECK(world->advance_frame());
  WEFT_CHECK(world->finish());
  return world->snapshot();
}

/// The world of a method with `steps` substeps a submit, at the common state.
Result<std::unique_ptr<sim::World>> start_world(gpu::Device& device, scene::Scene scene,
                                                const sim::Assets& assets, const sim::Snapshot& start,
                                                std::uint32_t steps) {
  WEFT_CHECK(fix_step(scene, assets, steps));
  WEFT_TRY(world, sim::World::create(device, scene, assets));
  world->restore(start);
  WEFT_CHECK(world->advance_frame());
  WEFT_CHECK(world->finish());
  return world;
}

Result<Row> measure(gpu::Device& device, const Case& c, scene::Scene scene, const sim::Assets& assets,
                    const sim::Snapshot& start, const Variant& variant) {
  scene.contact.method = variant.method;
  scene.contact.self = variant.self;
  scene::Scene at_60_hz = scene;
  WEFT_TRY(substeps, fix_step(at_60_hz, assets, kCountedSteps));
  WEFT_TRY(counted, start_world(device, scene, assets, start, kCountedSteps));
  WEFT_TRY(snapshot, counted->snapshot());
  Row row = describe(*counted, substeps);
  row.object = c.object;
  row.variant = variant.name;
  row.contacts = counted->totals().contacts;
  row.state_hash = snapshot.hash();
  const bool brute_force = variant.method == scene::ContactMethod::Paper;
  WEFT_TRY(world, start_world(device, scene, assets, start, brute_force ? kCountedSteps : c.quick ? 8 : 64));
  WEFT_TRY(timing, time_steps(*world, c.quick ? 200 : 300, brute_force ? 1 : 5));
  row.ms_per_step = timing.median;
  row.ms_per_step_min = timing.least;
  row.real_time_factor = 1000.0 / 60 / (timing.median * substeps);
  return row;
}

}  // namespace

Result<void> run_pull(gpu::Device& device, bool quick, const Folders& folders,
                      const std::function<Result<void>(const Row&)>& done) {
  const std::vector<const char*> objects = quick ? std::vector<const char*>{"sphere", "armadillo"}
                                                 : std::vector<const char*>{"sphere", "armadillo", "dragon"};
  const std::vector<std::uint32_t> sides =
      quick ? std::vector<std::uint32_t>{32, 64} : std::vector<std::uint32_t>{64, 100, 128, 256, 400, 800};
  for (const char* object : objects) {
    bool too_slow = false;
    for (const std::uint32_t side : sides) {
      const Case c{object, side, quick};
      WEFT_TRY(scene, load_case(c, folders));
      WEFT_TRY(assets, sim::load_assets(scene, folders.models));
      WEFT_TRY(start, warm_up(device, scene, assets, quick ? 0.05 : 0.4));
      for (const Variant& variant : kVariants) {
        if (variant.method == scene::ContactMethod::Paper && too_slow) {
          Row skipped;
          skipped.object = object;
          skipped.variant = "paper";
          skipped.nodes = static_cast<std::uint64_t>(side) * side;
          skipped.skipped = "the size before took over 2 s a step";
          WEFT_CHECK(done(skipped));
        } else {
          WEFT_TRY(row, measure(device, c, scene, assets, start, variant));
          too_slow = too_slow || row.ms_per_step > kSlowestStepMs;
          WEFT_CHECK(done(row));
        }
      }
    }
  }
  return {};
}

}  // namespace weft::bench
