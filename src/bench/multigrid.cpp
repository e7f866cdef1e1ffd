#include "bench/multigrid.hpp"

#include <algorithm>
#include <map>

#include "scene/load.hpp"

namespace weft::bench {
namespace {

using MultigridRowDone = std::function<Result<void>(const MultigridRow&)>;

constexpr std::string_view kMultigridNames[] = {"multigrid", "multigrid4", "multigrid16", "explicit",
                                                "null",      "fabric",     "drape"};
constexpr std::uint32_t kNullSides[] = {32, 64, 128, 256, 512};

/// An implicit variant: its substeps, and whether it is run unasked.
struct Implicit {
  std::string_view name;
  std::uint32_t substeps;
  bool unasked;
};
constexpr Implicit kImplicits[] = {
    {"multigrid4", 4, false}, {"multigrid", 8, true}, {"multigrid16", 16, false}};

bool asked(const Selection& selection, std::string_view name, bool unasked) {
  return selection.only.empty() ? unasked : selection.has_variant(name);
}

/// Frames after which states are compared: 0.25, 0.5 and 1 s.
std::vector<std::uint32_t> stops_of(const Selection& selection) {
  return selection.quick ? std::vector<std::uint32_t>{15} : std::vector<std::uint32_t>{15, 30, 60};
}

/// A scene of a sheet by two clips.
struct SheetScene {
  const char* name;      // its file, and the object of its rows
  const char* asked_by;  // a name of --only that stands for all its rows; null: they have names of their own
  std::uint32_t compared;  // the most nodes along an edge for which explicit steps are run
  bool has_null_lines;
};
constexpr std::uint32_t kAnySide = ~0U;
constexpr SheetScene kSheet = {"sheet", nullptr, kAnySide, true};
// Its explicit substeps grow with the square of the side: half an hour of them for 800.
constexpr SheetScene kFabric = {"fabric", "fabric", 256, false};

/// Where scenes come from.
struct Source {
  const Selection& selection;
  const Folders& folders;

  Result<scene::Scene> load(const std::string& name, std::span<const scene::Override> changes = {}) const {
    return scene::load_scene(folders.scenes + "/" + name + ".json", changes);
  }
};

/// A grid of so many nodes a side and its solver; `substeps` is a number or "auto".
std::vector<scene::Override> solved_by(std::uint32_t side, const char* kind, const std::string& substeps) {
  const std::string count = std::to_string(side);
  return {{"cloths.0.grid", "[" + count + "," + count + "]"},
          scene::override_solver(kind),
          {"time.substeps", substeps}};
}

MultigridRow begin_row(const std::string& object, const std::string& variant, std::uint32_t side) {
  MultigridRow row;
  row.object = object;
  row.variant = variant;
  row.side = side;
  row.nodes = row.simulated_nodes = static_cast<std::uint64_t>(side) * side;
  return row;
}

/// What a solver or the adapter refuses is a row that says so.
Result<void> report(Result<MultigridRow> measured, MultigridRow begun, const MultigridRowDone& done) {
  if (measured) return done(*measured);
  if (!skips_row(measured.error()) && measured.error().kind != ErrorKind::Input) return measured.error();
  begun.skipped = measured.error().message;
  return done(begun);
}

/// A run of the sheet, and its states at the times that are compared.
struct SheetRun {
  Model model;
  TimedRun run;
  std::vector<SheetShape> shapes;
  std::string state_hash;
};

Result<SheetRun> run_sheet(gpu::Device& device, const scene::Scene& scene,
                           const std::vector<std::uint32_t>& stops) {
  const Assets assets{{{}}};  // a grid comes from no file
  SheetRun made;
  WEFT_TRY(model, build_model(scene, assets.cloths));
  made.model = std::move(model);
  WEFT_TRY(run, run_timed(device, scene, assets, stops));
  made.run = std::move(run);
  for (std::size_t k = 0; k < stops.size(); ++k)
    made.shapes.push_back(shape_of(made.model, made.run.states[k], stops[k] * scene.time.frame));
  made.state_hash = made.run.states.back().hash();
  made.run.states.clear();  // the shapes have what is needed of them
  return made;
}

/// Runs the sheet; explicit runs once, since they are rows, and null lines of larger sheets.
class SheetBench {
 public:
  SheetBench(gpu::Device& device, const Source& source, const SheetScene& sheet, const MultigridRowDone& done)
      : device_(device), source_(source), sheet_(sheet), done_(done), stops_(stops_of(source.selection)) {}

  Result<void> run(std::uint32_t side) {
    const bool compares = side <= sheet_.compared;
    const Result<SheetRun> reference =
        compares
            ? run_reference(side)
            : Result<SheetRun>(make_error(
                  ErrorKind::Limit, "Explicit steps are run up to %u nodes along an edge.", sheet_.compared));
    for (const Implicit& variant : kImplicits) {
      if (!is_asked(variant.name, variant.unasked)) continue;
      const std::string substeps = std::to_string(variant.substeps);
      const MultigridRow begun = begin_row(sheet_.name, "multigrid " + substeps, side);
      WEFT_CHECK(
          report(compares ? measure_implicit(begun, reference, substeps) : measure_alone(begun, substeps),
                 begun, done_));
    }
    if (is_asked("explicit", true)) {
      const MultigridRow begun = begin_row(sheet_.name, "explicit", side);
      WEFT_CHECK(report(measure_explicit(begun, reference, side), begun, done_));
    }
    if (!sheet_.has_null_lines || !is_asked("null", true)) return {};
    for (const std::uint32_t coarse : kNullSides) {
      if (coarse >= side) break;
      MultigridRow begun = begin_row(sheet_.name, "null " + std::to_string(coarse), side);
      begun.simulated_nodes = static_cast<std::uint64_t>(coarse) * coarse;
      WEFT_CHECK(report(measure_explicit(begun, reference, coarse), begun, done_));
    }
    return {};
  }

 private:
  bool is_asked(std::string_view variant, bool unasked) const {
    if (sheet_.asked_by == nullptr) return asked(source_.selection, variant, unasked);
    return unasked && asked(source_.selection, sheet_.asked_by, true);
  }

  Result<SheetRun> run_new(const std::vector<scene::Override>& changes) {
    WEFT_TRY(scene, source_.load(sheet_.name, changes));
    return run_sheet(device_, scene, stops_);
  }

  Result<const SheetRun*> run_explicit(std::uint32_t side) {
    if (const auto found = explicit_.find(side); found != explicit_.end()) return &found->second;
    WEFT_TRY(made, run_new(solved_by(side, "mass_spring", "\"auto\"")));
    return &explicit_.emplace(side, std::move(made)).first->second;
  }

  /// Explicit steps of half the length that "auto" chooses.
  Result<SheetRun> run_reference(std::uint32_t side) {
    WEFT_CHECK(sim::check_node_count(static_cast<std::uint64_t>(side) * side, device_));
    WEFT_TRY(scene, source_.load(sheet_.name, solved_by(side, "mass_spring", "\"auto\"")));
    WEFT_TRY(substeps, count_substeps(scene, {{{}}}));
    return run_new(solved_by(side, "mass_spring", std::to_string(2 * substeps)));
  }

  Result<MultigridRow> measure_implicit(MultigridRow row, const Result<SheetRun>& reference,
                                        const std::string& substeps) {
    if (!reference) return reference.error();
    WEFT_TRY(made, run_new(solved_by(row.side, "multigrid", substeps)));
    return filled(std::move(row), *reference, made, made.shapes);
  }

  Result<MultigridRow> measure_alone(MultigridRow row, const std::string& substeps) {
    WEFT_TRY(made, run_new(solved_by(row.side, "multigrid", substeps)));
    row.run = made.run;
    row.state_hash = made.state_hash;
    return row;
  }

  Result<MultigridRow> measure_explicit(MultigridRow row, const Result<SheetRun>& reference,
                                        std::uint32_t side) {
    if (!reference) return reference.error();
    WEFT_TRY(made, run_explicit(side));
    if (side == row.side) return filled(std::move(row), *reference, *made, made->shapes);
    std::vector<SheetShape> drawn;
    for (const SheetShape& shape : made->shapes)
      drawn.push_back(upsampled(made->model, shape, reference->model));
    return filled(std::move(row), *reference, *made, drawn);
  }

  static MultigridRow filled(MultigridRow row, const SheetRun& reference, const SheetRun& made,
                             const std::vector<SheetShape>& drawn) {
    row.run = made.run;
    row.state_hash = made.state_hash;
    row.reference_substeps = reference.run.substeps;
    row.errors = sheet_errors(reference.model, drawn, reference.shapes);
    return row;
  }

  gpu::Device& device_;
  const Source& source_;
  const SheetScene& sheet_;
  const MultigridRowDone& done_;
  std::vector<std::uint32_t> stops_;
  std::map<std::uint32_t, SheetRun> explicit_;  // by side
};

Result<MultigridRow> measure_drape(gpu::Device& device, const Source& source, const Assets& assets,
                                   MultigridRow row) {
  WEFT_CHECK(sim::check_node_count(row.nodes, device));
  const char* solver = row.variant == "explicit" ? "mass_spring" : "multigrid";
  WEFT_TRY(scene, source.load("drape-" + row.object, solved_by(row.side, solver, "\"auto\"")));
  const std::uint32_t frames = source.selection.quick ? stops_of(source.selection).back() : scene.time.frames;
  WEFT_TRY(run, run_timed(device, scene, assets, std::vector{frames}));
  row.run = std::move(run);
  row.state_hash = row.run.states.back().hash();
  const sim::Totals& totals = row.run.totals;
  row.contact = {totals.contacts, totals.crossings, totals.crossings_left,
                 static_cast<double>(totals.max_stretch), totals.repeated_frames};
  return row;
}

Result<void> run_drapes(gpu::Device& device, const Source& source, std::vector<std::uint32_t> sides,
                        const MultigridRowDone& done) {
  if (sides.empty() && source.selection.quick) sides = {32};
  if (sides.empty()) sides = {256, 800};
  for (const char* object : {"armadillo", "dragon"}) {
    const std::string name = std::string("drape-") + object;
    WEFT_TRY(scene, source.load(name));
    WEFT_TRY(assets, load_assets(scene, source.folders.models));
    for (const std::uint32_t side : sides)
      for (const char* variant : {"multigrid", "explicit"}) {
        const MultigridRow begun = begin_row(object, variant, side);
        WEFT_CHECK(report(measure_drape(device, source, assets, begun), begun, done));
      }
  }
  return {};
}

}  // namespace

std::span<const std::string_view> multigrid_variants() { return kMultigridNames; }

Result<void> run_multigrid(gpu::Device& device, const Selection& selection, const Folders& folders,
                           const MultigridRowDone& done) {
  std::vector<std::uint32_t> sides = selection.sides;
  if (sides.empty() && selection.quick) sides = {32, 64};
  if (sides.empty()) sides = {64, 128, 256, 512, 800};
  const Source source{selection, folders};
  const bool hangs =
      std::any_of(std::begin(kMultigridNames), std::end(kMultigridNames), [&](std::string_view name) {
        return name != "fabric" && name != "drape" && asked(selection, name, true);
      });
  for (const SheetScene& scene : {kSheet, kFabric}) {
    if (scene.asked_by != nullptr ? !asked(selection, scene.asked_by, !selection.quick) : !hangs) continue;
    WEFT_TRY(sheet, source.load(scene.name));  // a missing file is no skipped row
    SheetBench sheets(device, source, scene, done);
    for (const std::uint32_t side : sides) WEFT_CHECK(sheets.run(side));
  }
  if (asked(selection, "drape", !selection.quick))
    WEFT_CHECK(run_drapes(device, source, selection.sides, done));
  return {};
}

}  // namespace weft::bench
