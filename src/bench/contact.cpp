#include "bench/contact.hpp"

#include <algorithm>

#include "bench/folds.hpp"
#include "bench/round_object.hpp"
#include "bench/row.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/contact_steps.hpp"
#include "model/attachments.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

using ContactRowDone = std::function<Result<void>(const ContactRow&)>;

constexpr std::uint32_t kLayers = 8;  // of a folded sheet
constexpr std::uint64_t kSeed = 1;
constexpr double kSettle = 0.02;  // m, the height at which sheets lie, as in scenes/stack.json

Effort effort_of(bool quick) { return quick ? Effort{8, 1, 0, 1} : Effort{32, 16, 300, 5}; }

/// A scene at the step that "auto" chooses, whatever starts in it.
struct Setting {
  scene::Scene scene;
  Assets assets;
  Model model;
  std::uint32_t substeps = 0;  // of a 60 Hz frame
  Timing free_step;
};

Result<Setting> make_setting(gpu::Device& device, scene::Scene scene, Assets assets, const Effort& effort) {
  Setting made{std::move(scene), std::move(assets)};
  WEFT_TRY(substeps, fix_step(made.scene, made.assets, effort.steps));
  made.substeps = substeps;
  WEFT_TRY(model, build_model(made.scene, made.assets));
  made.model = std::move(model);
  scene::Scene free = made.scene;
  free.contact.method = scene::ContactMethod::None;
  // One substep at a time, as with contact: the difference is what contact costs.
  WEFT_TRY(world, sim::World::create(device, std::move(free), made.assets, {.two_steps = false}));
  WEFT_TRY(timing, time_steps(*world, effort.budget_ms, effort.least_submits));
  made.free_step = timing;
  return made;
}

struct ContactVariant {
  const char* name;
  scene::ContactMethod method;
  bool self;
};
constexpr ContactVariant kSelf{"proximity_self", scene::ContactMethod::Proximity, true};
constexpr ContactVariant kVariants[] = {
    {"bvh", scene::ContactMethod::Bvh, false}, {"proximity", scene::ContactMethod::Proximity, false}, kSelf};

/// What a row says before it is measured.
ContactRow begin_row(const Setting& setting, const char* pose, const ContactVariant& variant) {
  ContactRow row;
  row.pose = pose;
  row.method = variant.name;
  row.sheets = setting.model.bodies.size();
  row.nodes = setting.model.vertex_count();
  row.cloth_triangles = setting.model.triangles.size();
  for (const mesh::TriangleMesh& object : setting.assets.objects)
    row.object_triangles += object.triangles.size();
  row.substeps = setting.substeps;
  row.free_step = setting.free_step;
  return row;
}

/// Runs the counted submit, from rest at these places.
Result<void> run_counted(sim::World& world, const std::vector<Vec3d>& places) {
  WEFT_TRY(start, world.snapshot());
  for (std::size_t node = 0; node < places.size(); ++node)
    start.position[node] = Vec4f::from(places[node].to<float>(), start.position[node].w);
  WEFT_CHECK(world.restore(start));
  WEFT_CHECK(world.advance_frame());
  return world.finish();
}

Result<ContactRow> measure(gpu::Device& device, const Setting& setting, const std::vector<Vec3d>& places,
                           const ContactVariant& variant, const Effort& effort, ContactRow row) {
  scene::Scene scene = setting.scene;
  scene.contact.method = variant.method;
  scene.contact.self = variant.self;
  WEFT_TRY(world, sim::World::create(device, std::move(scene), setting.assets));
  WEFT_CHECK(run_counted(*world, places));
  WEFT_TRY(counted, world->snapshot());
  row.state_hash = counted.hash();
  row.counted_steps = world->substeps();
  row.contacts = world->totals().contacts;
  row.dispatches_per_step = dispatches_per_step(*world);

  const bool searches = !search_dispatches(*world).empty();
  if (searches) {
    // The next frame begins with this search, so after it the lists are long enough.
    WEFT_CHECK(world->advance_frame());
    WEFT_CHECK(world->finish());
    WEFT_CHECK(world->restore(counted));
    WEFT_TRY(search, time_search(*world, effort));
    row.search = search.timing;
    row.pairs = search.pairs;
    row.candidates = search.candidates;
  }
  const sim::Totals before = world->totals();
  WEFT_TRY(step, time_steps(*world, effort.budget_ms, effort.least_submits));
  row.step = step;
  const sim::Totals after = world->totals();
  row.crossings = after.crossings;
  if (searches) {
    const double in_submit = static_cast<double>(after.detections - before.detections) /
                             static_cast<double>(after.frames - before.frames);
    // The first step of a frame always searches, whatever its length; of the others one in search_interval may.
    const std::uint32_t interval = world->plan().method().search_interval;
    const auto chances = [&](std::uint32_t steps) { return (steps - 1) / interval; };
    row.searches_per_frame = 1 + (in_submit - 1) * chances(row.substeps) / chances(effort.steps);
  }
  WEFT_TRY(kernels, sim::time_kernels(*world, effort.least_submits));
  row.kernels = std::move(kernels);
  return row;
}

/// What cannot be run here, or did not stay finite, is a row that says so.
Result<void> report(Result<ContactRow> measured, ContactRow begun, const ContactRowDone& done) {
  if (measured) return done(*measured);
  if (!skips_row(measured.error())) return measured.error();
  begun.skipped = measured.error().message;
  return done(begun);
}

// ---- Cloth that meets itself ----

struct Sheets {
  std::uint32_t side, count;
};

Result<scene::Scene> load_sheets(const Sheets& sheets, const std::string& scenes_folder) {
  const std::string side = std::to_string(sheets.side);
  const std::vector<scene::Override> overrides = {
      {"cloths.0.grid", "[" + side + "," + side + "]"},
      {"cloths.0.copies.count", std::to_string(sheets.count)},
      {"cloths.0.damping", "0.001"}};  // N·s/m; the scene's would make fine sheets need shorter steps
  return scene::load_scene(scenes_folder + "/stack.json", overrides);
}

/// Each sheet folded alike, sheet upon sheet. `sway` is the slope of the folds along themselves.
std::vector<Vec3d> folded_places(const Model& model, const Folds& folds, double sway) {
  std::vector<Vec3d> places;
  const double sheet_height = static_cast<double>(folds.layers.size()) * folds.gap;
  for (std::size_t c = 0; c < model.bodies.size(); ++c) {
    const mesh::Grid& grid = *model.bodies[c].grid;
    const std::vector<Vec3d> row = fold_profile(grid.nx, grid.width / (grid.nx - 1), folds),
                             column = fold_column(grid.ny, grid.height / (grid.ny - 1), sway, kSeed);
    for (const Vec3d& along : column)
      for (const Vec3d& across : row)
        places.push_back(across + along + Vec3d{0, static_cast<double>(c) * sheet_height, 0});
  }
  double lowest = places[0].y;
  for (const Vec3d& p : places) lowest = std::min(lowest, p.y);
  for (Vec3d& p : places) p.y += kSettle - lowest;
  return places;
}

Result<void> run_sheets(gpu::Device& device, const Sheets& sheets, const std::vector<double>& parts,
                        const std::string& scenes_folder, const Effort& effort, const ContactRowDone& done) {
  WEFT_TRY(scene, load_sheets(sheets, scenes_folder));
  WEFT_TRY(setting, make_setting(device, std::move(scene), Assets{{{}}}, effort));
  const Model& model = setting.model;
  const double size = model.bodies[0].grid->width;  // m
  const double gap = self_thickness(model, setting.scene.contact.thickness);
  const auto run = [&](const char* pose, const std::vector<Vec3d>& places, double part) {
    ContactRow row = begin_row(setting, pose, kSelf);
    row.part = part;
    return report(measure(device, setting, places, kSelf, effort, row), row, done);
  };
  WEFT_CHECK(run("flat", model.rest_position, 1));
  for (const double part : parts) {
    WEFT_CHECK(run("folded", folded_places(model, even_folds(size, gap, kLayers, part), 0), part));
    // Where the wave is steepest the layers of a crumpled sheet come to 1 / √(1 + slope²) = 0.55 of this, so
    // some touch.
    const Folds folds = crumpled_folds(size, 1.7 * gap, kLayers, part, kSeed);
    WEFT_CHECK(run("crumpled", folded_places(model, folds, 0.1), part));
  }
  return {};
}

// ---- Cloth on an object ----

constexpr const char* kDrapedScene = R"({"format": "weft-scene/1", "drag": 0.5, "time": {"substeps": "auto"},
  "solver": {"kind": "mass_spring"}, "contact": {"method": "proximity", "thickness": 0.003},
  "cloths": [{"mesh": "sheet", "density": 0.3, "friction": 0.4, "damping": 0.001,
              "stiffness": {"structural": 300, "shear": 40, "bend": 1}}],
  "colliders": [{"kind": "mesh", "mesh": "round"}]})";

/// The same sheet on an object that turns under it, and before its middle another one, which swells by a hundredth in a
/// second: all triangles of that one move, and all boxes of its tree with them.
constexpr const char* kMovingScene = R"({"format": "weft-scene/1", "drag": 0.5, "time": {"substeps": "auto"},
  "solver": {"kind": "mass_spring"}, "contact": {"method": "proximity", "thickness": 0.003},
  "cloths": [{"mesh": "sheet", "density": 0.3, "friction": 0.4, "damping": 0.001,
              "stiffness": {"structural": 300, "shear": 40, "bend": 1}}],
  "colliders": [
    {"kind": "mesh", "mesh": "round", "motion": {"kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0],
                                                "speed": 0.5}},
    {"kind": "mesh", "mesh": "round", "transform": {"translate": [0, 1.24, 0]},
     "keyframes": [{"time": 1, "mesh": "swollen"}]}]})";
constexpr double kSwollen = 1.01;

Result<void> run_over(gpu::Device& device, const char* pose, const char* scene_text,
                      std::span<const ContactVariant> variants, std::uint32_t side,
                      std::uint32_t object_triangles, const Effort& effort, const ContactRowDone& done) {
  WEFT_TRY(scene, scene::parse_scene(scene_text, "bench contact"));
  const auto read = [&](const std::string& name) -> Result<mesh::TriangleMesh> {
    if (name == "sheet") return make_round_sheet(side, 1, scene.contact.thickness);
    mesh::TriangleMesh object = make_round_object(object_triangles);
    if (name == "swollen")
      for (Vec3f& p : object.positions) p = (kSwollen * p.to<double>()).to<float>();
    return object;
  };
  WEFT_TRY(assets, load_assets(scene, read));
  WEFT_TRY(setting, make_setting(device, std::move(scene), std::move(assets), effort));
  for (const ContactVariant& variant : variants) {
    const ContactRow row = begin_row(setting, pose, variant);
    WEFT_CHECK(
        report(measure(device, setting, setting.model.rest_position, variant, effort, row), row, done));
  }
  return {};
}

Result<void> run_draped(gpu::Device& device, std::uint32_t side, std::uint32_t object_triangles,
                        const Effort& effort, const ContactRowDone& done) {
  return run_over(device, "draped", kDrapedScene, kVariants, side, object_triangles, effort, done);
}
/// `bvh` knows no colliders that move.
Result<void> run_moving(gpu::Device& device, std::uint32_t side, std::uint32_t object_triangles,
                        const Effort& effort, const ContactRowDone& done) {
  return run_over(device, "moving", kMovingScene, std::span(kVariants).subspan(1), side, object_triangles,
                  effort, done);
}

}  // namespace

Result<void> run_contact(gpu::Device& device, bool quick, const std::string& scenes_folder,
                         const ContactRowDone& done) {
  const Effort effort = effort_of(quick);
  if (quick) {
    WEFT_CHECK(run_sheets(device, {20, 2}, {1}, scenes_folder, effort, done));
    WEFT_CHECK(run_draped(device, 24, 5000, effort, done));
    return run_moving(device, 24, 5000, effort, done);
  }
  // The largest come last, so that a run that is cut off lacks least.
  for (const Sheets& sheets : {Sheets{100, 1}, Sheets{256, 1}, Sheets{400, 1}, Sheets{70, 50}}) {
    const bool sweep = sheets.side == 256;  // contacts at one size
    const std::vector<double> parts = sweep ? std::vector{0.125, 0.25, 0.5, 1.0} : std::vector{0.125, 1.0};
    WEFT_CHECK(run_sheets(device, sheets, parts, scenes_folder, effort, done));
  }
  for (const std::uint32_t object_triangles : {10000U, 100000U, 1000000U})
    WEFT_CHECK(run_draped(device, 256, object_triangles, effort, done));
  WEFT_CHECK(run_draped(device, 100, 1000000, effort, done));
  WEFT_CHECK(run_draped(device, 800, 1000000, effort, done));
  for (const std::uint32_t side : {256U, 800U}) WEFT_CHECK(run_moving(device, side, 1000000, effort, done));
  WEFT_CHECK(run_sheets(device, {800, 1}, {0.125, 1}, scenes_folder, effort, done));
  return {};
}

}  // namespace weft::bench
