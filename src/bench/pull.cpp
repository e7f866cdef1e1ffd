#include "bench/pull.hpp"

#include <cmath>

#include "bench/crossing_count.hpp"
#include "bench/drawn_frames.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr double kSlowestStepMs = 2000;
constexpr std::uint32_t kCountedSteps =
    2;  // the same for all methods, so that contacts and hashes can be compared

/// How contact is found; names stand in results.
struct PullVariant {
  scene::ContactMethod method;
  bool self = false;
};
constexpr PullVariant kVariants[] = {{scene::ContactMethod::None},
                                     {scene::ContactMethod::Bvh},
                                     {scene::ContactMethod::Proximity},
                                     {scene::ContactMethod::Proximity, true},
                                     {scene::ContactMethod::Paper}};
constexpr std::string_view kPullNames[] = {"none", "bvh", "proximity", "proximity_self", "paper"};
constexpr std::string_view kObjects[] = {"sphere", "armadillo", "dragon"};

struct Case {
  std::string object;
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
Result<sim::Snapshot> warm_up(gpu::Device& device, scene::Scene scene, const Assets& assets, double seconds) {
  scene.contact.method = scene::ContactMethod::Proximity;
  WEFT_TRY(world, sim::World::create(device, scene, assets));
  const int frames = static_cast<int>(std::ceil(seconds / scene.time.frame));
  for (int frame = 0; frame < frames; ++frame) WEFT_CHECK(world->advance_frame());
  WEFT_CHECK(world->finish());
  return world->snapshot();
}

/// The world of a method with `steps` substeps a submit, at the common state.
Result<std::unique_ptr<sim::World>> start_world(gpu::Device& device, scene::Scene scene, const Assets& assets,
                                                const sim::Snapshot& start, std::uint32_t steps) {
  WEFT_CHECK(fix_step(scene, assets, steps));
  // One substep at a time also where there is no contact, so that the difference is what contact costs.
  WEFT_TRY(world, sim::World::create(device, scene, assets, {.two_steps = false}));
  world->restore(start);
  WEFT_CHECK(world->advance_frame());
  WEFT_CHECK(world->finish());
  return world;
}

/// What the methods of one size share.
struct Setting {
  scene::Scene scene;
  Assets assets;
  sim::Snapshot start;
  CrossingCount crossings;
};

Result<Setting> make_setting(gpu::Device& device, const Case& c, const Folders& folders) {
  WEFT_CHECK(sim::check_node_count(static_cast<std::uint64_t>(c.side) * c.side, device));
  WEFT_TRY(scene, load_case(c, folders));
  WEFT_TRY(assets, load_assets(scene, folders.models));
  WEFT_TRY(start, warm_up(device, scene, assets, c.quick ? 0.05 : 0.4));
  WEFT_TRY(crossings, CrossingCount::create(device, scene, assets));
  return Setting{std::move(scene), std::move(assets), std::move(start), std::move(crossings)};
}

Result<Row> measure(gpu::Device& device, const Case& c, Setting& setting, const PullVariant& variant,
                    Row row) {
  scene::Scene scene = setting.scene;
  scene.contact.method = variant.method;
  scene.contact.self = variant.self;
  const bool brute_force = variant.method == scene::ContactMethod::Paper;
  scene::Scene stepped = scene;
  WEFT_TRY(substeps, fix_step(stepped, setting.assets, kCountedSteps));
  {
    WEFT_TRY(counted, start_world(device, scene, setting.assets, setting.start, kCountedSteps));
    WEFT_TRY(snapshot, counted->snapshot());
    describe(row, *counted, substeps);
    row.contacts = counted->totals().contacts;
    row.state_hash = snapshot.hash();
    WEFT_TRY(crossings, setting.crossings.of(snapshot));
    row.outcome = {crossings, static_cast<double>(counted->totals().max_stretch)};
  }
  const std::uint32_t least = brute_force ? 1 : 5;
  {
    const std::uint64_t before = device.allocated_bytes();
    const std::uint32_t steps = brute_force ? kCountedSteps : c.quick ? 8 : 64;
    WEFT_TRY(world, start_world(device, scene, setting.assets, setting.start, steps));
    WEFT_CHECK(time_row(row, *world, c.quick ? 200 : 300, least));
    row.gpu_bytes = device.allocated_bytes() - before;
  }
  WEFT_TRY(frame,
           time_drawn_frames(device, stepped, setting.assets, &setting.start, c.quick ? 100 : 300, least));
  row.paper_frame = frame;
  return row;
}

}  // namespace

std::span<const std::string_view> pull_variants() { return kPullNames; }
std::span<const std::string_view> pull_objects() { return kObjects; }

Result<void> run_pull(gpu::Device& device, const Selection& selection, const Folders& folders,
                      const std::function<Result<void>(const Row&)>& done) {
  std::vector<std::string> objects = selection.objects;
  if (objects.empty()) objects.assign(std::begin(kObjects), std::end(kObjects) - (selection.quick ? 1 : 0));
  std::vector<std::uint32_t> sides = selection.sides;
  if (sides.empty() && selection.quick) sides = {32, 64};
  if (sides.empty()) sides = {64, 100, 128, 256, 400, 800};
  for (const std::string& object : objects) {
    bool too_slow = false;
    for (const std::uint32_t side : sides) {
      const Case c{object, side, selection.quick};
      Result<Setting> setting = make_setting(device, c, folders);
      for (std::size_t k = 0; k < std::size(kVariants); ++k) {
        if (!selection.has_variant(kPullNames[k])) continue;
        Row begun;
        begun.object = object;
        begun.variant = kPullNames[k];
        begun.side = side;
        if (kVariants[k].method == scene::ContactMethod::Paper && too_slow) {
          WEFT_CHECK(done(skipped_row(begun, "the size before took over 2 s a step")));
          continue;
        }
        WEFT_TRY(row, or_skipped(setting ? measure(device, c, *setting, kVariants[k], begun)
                                         : Result<Row>(setting.error()),
                                 begun));
        too_slow = too_slow || row.step.median > kSlowestStepMs;
        WEFT_CHECK(done(row));
      }
    }
  }
  return {};
}

}  // namespace weft::bench
