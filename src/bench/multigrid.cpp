#include "bench/multigrid.hpp"

#include <algorithm>
#include <map>

#include "bench/scene_run.hpp"
#include "bench/sheet_runs.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

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

constexpr const char* kImplicit = "multigrid";

/// Runs the sheet; explicit runs once, since they are rows, and null lines of larger sheets.
class SheetBench {
 public:
  SheetBench(const Selection& selection, const SheetScene& sheet, SheetRuns runs, const SheetRowDone& done)
      : selection_(selection), sheet_(sheet), runs_(std::move(runs)), done_(done) {}

  Result<void> run(std::uint32_t side) {
    const bool compares = side <= sheet_.compared;
    const Result<SheetRun> reference =
        compares
            ? runs_.run_reference(side)
            : Result<SheetRun>(make_error(
                  ErrorKind::Limit, "Explicit steps are run up to %u nodes along an edge.", sheet_.compared));
    for (const Implicit& variant : kImplicits) {
      if (!is_asked(variant.name, variant.unasked)) continue;
      const std::string substeps = std::to_string(variant.substeps);
      const SheetRow begun = begin_row(sheet_.name, "multigrid " + substeps, side);
      WEFT_CHECK(
          report(compares ? measure_implicit(begun, reference, substeps) : measure_alone(begun, substeps),
                 begun, done_));
    }
    if (is_asked("explicit", true)) {
      const SheetRow begun = begin_row(sheet_.name, "explicit", side);
      WEFT_CHECK(report(measure_explicit(begun, reference, side), begun, done_));
    }
    if (!sheet_.has_null_lines || !is_asked("null", true)) return {};
    for (const std::uint32_t coarse : kNullSides) {
      if (coarse >= side) break;
      SheetRow begun = begin_row(sheet_.name, "null " + std::to_string(coarse), side);
      begun.simulated_nodes = static_cast<std::uint64_t>(coarse) * coarse;
      WEFT_CHECK(report(measure_explicit(begun, reference, coarse), begun, done_));
    }
    return {};
  }

 private:
  bool is_asked(std::string_view variant, bool unasked) const {
    if (sheet_.asked_by == nullptr) return asked(selection_, variant, unasked);
    return unasked && asked(selection_, sheet_.asked_by, true);
  }

  Result<const SheetRun*> run_explicit(std::uint32_t side) {
    if (const auto found = explicit_.find(side); found != explicit_.end()) return &found->second;
    WEFT_TRY(made, runs_.run_explicit(side));
    return &explicit_.emplace(side, std::move(made)).first->second;
  }

  Result<SheetRow> measure_implicit(SheetRow row, const Result<SheetRun>& reference,
                                    const std::string& substeps) {
    if (!reference) return reference.error();
    WEFT_TRY(made, runs_.run(runs_.sheet().solved_by(row.side, kImplicit, substeps)));
    return filled(std::move(row), *reference, made, made.shapes);
  }

  Result<SheetRow> measure_alone(SheetRow row, const std::string& substeps) {
    WEFT_TRY(made, runs_.run(runs_.sheet().solved_by(row.side, kImplicit, substeps)));
    return timed(std::move(row), made);
  }

  Result<SheetRow> measure_explicit(SheetRow row, const Result<SheetRun>& reference, std::uint32_t side) {
    if (!reference) return reference.error();
    WEFT_TRY(made, run_explicit(side));
    if (side == row.side) return filled(std::move(row), *reference, *made, made->shapes);
    std::vector<SheetShape> drawn;
    for (const SheetShape& shape : made->shapes)
      drawn.push_back(upsampled(made->model, shape, reference->model));
    return filled(std::move(row), *reference, *made, drawn);
  }

  const Selection& selection_;
  const SheetScene& sheet_;
  SheetRuns runs_;
  const SheetRowDone& done_;
  std::map<std::uint32_t, SheetRun> explicit_;  // by side
};

std::string drape_of(const Folders& folders, const std::string& object) {
  return folders.scenes + "/drape-" + object + ".json";
}

Result<SheetRow> measure_drape(gpu::Device& device, const Selection& selection, const Folders& folders,
                               const Assets& assets, SheetRow row) {
  WEFT_CHECK(sim::check_node_count(row.nodes, device));
  const char* solver = row.variant == "explicit" ? "mass_spring" : kImplicit;
  WEFT_TRY(scene, scene::load_scene(drape_of(folders, row.object),
                                    SheetOfRuns().solved_by(row.side, solver, "\"auto\"")));
  if (selection.quick) scene.time.frames = stops_of(selection).back();
  return measure_scene(device, scene, assets, std::move(row));
}

Result<void> run_drapes(gpu::Device& device, const Selection& selection, const Folders& folders,
                        const SheetRowDone& done) {
  std::vector<std::uint32_t> sides = selection.sides;
  if (sides.empty() && selection.quick) sides = {32};
  if (sides.empty()) sides = {256, 800};
  for (const char* object : {"armadillo", "dragon"}) {
    WEFT_TRY(scene, scene::load_scene(drape_of(folders, object)));
    WEFT_TRY(assets, load_assets(scene, folders.models));
    for (const std::uint32_t side : sides)
      for (const char* variant : {"multigrid", "explicit"}) {
        const SheetRow begun = begin_row(object, variant, side);
        WEFT_CHECK(report(measure_drape(device, selection, folders, assets, begun), begun, done));
      }
  }
  return {};
}

}  // namespace

std::span<const std::string_view> multigrid_variants() { return kMultigridNames; }

Result<void> run_multigrid(gpu::Device& device, const Selection& selection, const Folders& folders,
                           const SheetRowDone& done) {
  std::vector<std::uint32_t> sides = selection.sides;
  if (sides.empty() && selection.quick) sides = {32, 64};
  if (sides.empty()) sides = {64, 128, 256, 512, 800};
  const bool hangs =
      std::any_of(std::begin(kMultigridNames), std::end(kMultigridNames), [&](std::string_view name) {
        return name != "fabric" && name != "drape" && asked(selection, name, true);
      });
  for (const SheetScene& scene : {kSheet, kFabric}) {
    if (scene.asked_by != nullptr ? !asked(selection, scene.asked_by, !selection.quick) : !hangs) continue;
    WEFT_TRY(runs, SheetRuns::create(device, folders, {scene.name, {}, stops_of(selection)}));
    SheetBench sheets(selection, scene, std::move(runs), done);
    for (const std::uint32_t side : sides) WEFT_CHECK(sheets.run(side));
  }
  if (asked(selection, "drape", !selection.quick)) WEFT_CHECK(run_drapes(device, selection, folders, done));
  return {};
}

}  // namespace weft::bench
