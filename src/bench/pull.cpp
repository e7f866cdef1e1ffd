#include "bench/pull.hpp"

#include <algorithm>
#include <optional>

#include "bench/crossing_count.hpp"
#include "bench/drawn_frames.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr double kSlowestStepMs = 2000;
constexpr std::uint32_t kCountedSteps =
    2;                                // the same for all methods, so that contacts and hashes can be compared
constexpr double kOwnContact = 0.15;  // s by each method's own contact, before it is compared with the others
constexpr double kNear = 0.1;         // s from a pose that are timed: 6 cm of a pull of 50 cm

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

/// When the sheet is pulled at full speed [s].
struct Pull {
  double begin = 0, end = 0;
};
Result<Pull> pull_of(const scene::Scene& scene) {
  for (const scene::Cloth& cloth : scene.cloths)
    for (const scene::Motion& motion : cloth.motions)
      if (const auto* line = std::get_if<scene::MotionLine>(&motion.shape))
        if (line->distance && *line->distance / line->speed > line->ramp)
          return Pull{line->start + line->ramp, line->start + *line->distance / line->speed};
  return input_error("No cloth of the scene is pulled along a line at a steady speed.");
}

Result<void> run_to(sim::World& world, double time) {
  while (world.time() + 0.5 * world.scene().time.frame < time) WEFT_CHECK(world.advance_frame());
  return world.finish();
}

/// The world of a scene with `steps` substeps a submit.
Result<std::unique_ptr<sim::World>> make_world(gpu::Device& device, scene::Scene scene, const Assets& assets,
                                               std::uint32_t steps) {
  WEFT_CHECK(fix_step(scene, assets, steps));
  // One substep at a time also where there is no contact, so that the difference is what contact costs.
  return sim::World::create(device, std::move(scene), assets, {.two_steps = false});
}

/// What the methods of one size share.
struct Setting {
  scene::Scene scene;
  Assets assets;
  Pull pull;
  /// Where its full speed begins, reached without a crossing: by proximity with self-contact.
  sim::Snapshot pulled;
  CrossingCount crossings;
};

scene::Scene scene_of(const Setting& setting, scene::ContactMethod method, bool self) {
  scene::Scene scene = setting.scene;
  scene.contact.method = method;
  scene.contact.self = self;
  return scene;
}

Result<Setting> make_setting(gpu::Device& device, const Case& c, const Folders& folders) {
  WEFT_CHECK(sim::check_node_count(static_cast<std::uint64_t>(c.side) * c.side, device));
  WEFT_TRY(scene, load_case(c, folders));
  WEFT_TRY(assets, load_assets(scene, folders.models));
  WEFT_TRY(pull, pull_of(scene));
  WEFT_TRY(crossings, CrossingCount::create(device, scene, assets));
  Setting made{std::move(scene), std::move(assets), pull, {}, std::move(crossings)};
  WEFT_TRY(world,
           sim::World::create(device, scene_of(made, scene::ContactMethod::Proximity, true), made.assets));
  WEFT_CHECK(run_to(*world, pull.begin));
  WEFT_TRY(pulled, world->snapshot());
  made.pulled = std::move(pulled);
  return made;
}

/// The pose of a contact method, to which its own contact has brought the sheet: what keeps a distance never comes
/// to where a method that pushes out what has entered would find a hit. Searched until the counted steps have hits.
/// Errors  Limit: they have none while the sheet is pulled.
Result<Pose> find_pose(gpu::Device& device, const Setting& setting, scene::ContactMethod method, bool self) {
  const scene::Scene scene = scene_of(setting, method, self);
  WEFT_TRY(world, sim::World::create(device, scene, setting.assets));
  WEFT_CHECK(world->restore(setting.pulled));
  WEFT_CHECK(run_to(*world, setting.pull.begin + kOwnContact));
  WEFT_TRY(counting, make_world(device, scene, setting.assets, kCountedSteps));
  for (;;) {
    WEFT_TRY(state, world->snapshot());
    Pose pose{std::move(state), world->time() + kNear};
    if (pose.until > setting.pull.end)
      return make_error(ErrorKind::Limit,
                        "no %u steps have a hit from %g s to %g s, while the sheet is pulled", kCountedSteps,
                        setting.pull.begin + kOwnContact, world->time());
    const std::uint64_t before = counting->totals().contacts;
    WEFT_CHECK(begin_at(pose, *counting));
    if (counting->totals().contacts > before) return pose;
    WEFT_CHECK(world->advance_frame());
    WEFT_CHECK(world->finish());
  }
}

/// The poses that have been found: of each method that finds other contacts.
class Poses {
 public:
  Result<Pose> of(gpu::Device& device, const Setting& setting, const PullVariant& variant) {
    const bool pushes =
        variant.method == scene::ContactMethod::Bvh || variant.method == scene::ContactMethod::Paper;
    std::optional<Result<Pose>>& found = pushes ? pushes_ : variant.self ? self_ : proximity_;
    if (!found)
      found = find_pose(device, setting, pushes ? scene::ContactMethod::Bvh : scene::ContactMethod::Proximity,
                        variant.self);
    return *found;
  }

 private:
  // Of bvh and paper; of proximity and none; with self-contact.
  std::optional<Result<Pose>> pushes_, proximity_, self_;
};

Result<Row> measure(gpu::Device& device, const Case& c, Setting& setting, Poses& poses,
                    const PullVariant& variant, Row row) {
  WEFT_TRY(pose, poses.of(device, setting, variant));
  const scene::Scene scene = scene_of(setting, variant.method, variant.self);
  const bool brute_force = variant.method == scene::ContactMethod::Paper;
  scene::Scene stepped = scene;
  WEFT_TRY(substeps, fix_step(stepped, setting.assets, kCountedSteps));
  {
    WEFT_TRY(counted, make_world(device, scene, setting.assets, kCountedSteps));
    WEFT_CHECK(begin_at(pose, *counted));
    WEFT_TRY(snapshot, counted->snapshot());
    describe(row, *counted, substeps);
    row.start = pose.state.time.seconds();
    row.contacts = counted->totals().contacts;
    row.state_hash = snapshot.hash();
    WEFT_TRY(crossings, setting.crossings.of(snapshot));
    row.outcome = {crossings, static_cast<double>(counted->totals().max_stretch)};
  }
  const std::uint32_t least = brute_force ? 1 : 5;
  {
    const std::uint64_t before = device.allocated_bytes();
    const auto most =
        static_cast<std::uint32_t>(0.5 * kNear * 60 * substeps);  // two submits at least stay near
    const std::uint32_t steps = brute_force ? kCountedSteps : std::clamp(most, 1U, c.quick ? 8U : 64U);
    WEFT_TRY(world, make_world(device, scene, setting.assets, steps));
    WEFT_CHECK(begin_at(pose, *world));
    WEFT_CHECK(time_row(row, *world, c.quick ? 200 : 300, least, &pose));
    row.gpu_bytes = device.allocated_bytes() - before;
  }
  WEFT_TRY(frame, time_drawn_frames(device, stepped, setting.assets, &pose, c.quick ? 100 : 300, least));
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
      Poses poses;
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
        WEFT_TRY(row, or_skipped(setting ? measure(device, c, *setting, poses, kVariants[k], begun)
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
