#include "bench/methods.hpp"

#include <algorithm>
#include <array>

#include "bench/sheet_runs.hpp"
#include "method/method.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

/// Of a frame: more take five times its length and longer on any GPU.
constexpr std::uint32_t kMostSweeps = 1024;
constexpr std::uint32_t kCoarseSides[] = {32, 64, 128, 256};

/// Springs that every method takes, of the sheet's own moduli; bend springs instead of its bending [N/m].
const scene::Override kSprings = {"cloths.0.stiffness", R"({"structural": 1500, "shear": 750, "bend": 15})"};

/// A scene that every method steps.
struct MethodScene {
  std::string_view name;  // the object of its rows
  SheetOfRuns sheet;
  std::vector<std::uint32_t> sides;  // as it is run unasked
  bool meets_contact = false;        // then fewer sweeps are tried, and no null lines
};

std::vector<MethodScene> scenes_of(const Selection& selection) {
  const std::vector<std::uint32_t> stops = stops_of(selection);
  std::vector<std::uint32_t> late = stops;  // what is wrung takes longer to meet itself
  for (std::uint32_t& stop : late) stop *= 2;
  return {
      {"sheet", {"sheet", {kSprings}, stops}, {64, 100, 256, 317, 800}},
      {"strip",
       {"sheet",
        {kSprings, {"cloths.0.size", "[1.2, 0.3]"}, {"cloths.0.bump", "0"}, {"cloths.0.pins", R"(["left"])"}},
        stops,
        4},
       {64, 256}},
      // Its weight bends it by G = density g L^3 / B = 10: src/closed_forms/elastica.hpp.
      {"cantilever",
       {"fabric",
        {{"cloths.0.size", "[0.5, 0.125]"},
         {"cloths.0.bump", "0"},
         {"cloths.0.fabric", R"({"warp": 2000, "shear": 750, "poisson": 0.3333, "bending_warp": 0.0184})"},
         {"cloths.0.pins", R"([{"box": {"min": [-1, -1, -1], "max": [-0.23, 1, 1]}}])"}},
        stops,
        4},
       {32, 64}},
      {"ball", {"drape-sphere", {}, stops}, {100, 256}, true},
      {"armadillo", {"drape-armadillo", {}, stops}, {100, 256}, true},
      {"twist", {"twist", {}, late}, {100, 256}, true},
      // The paper's second experiment; the pull begins after a quarter of a second.
      {"pull-sphere", {"pull-sphere", {}, late}, {100}, true},
      {"pull-armadillo", {"pull-armadillo", {}, late}, {100}, true},
      {"pull-dragon", {"pull-dragon", {}, late}, {100}, true},
  };
}

/// How a method steps in a row.
struct Steps {
  std::string variant, substeps;
  std::vector<scene::Override> settings;  // of the solver
};

/// Substeps, and sweeps of each, of methods that sweep.
std::vector<std::array<std::uint32_t, 2>> sweeps_of(bool meets_contact, bool quick) {
  if (quick) return {{8, 4}};
  if (meets_contact) return {{8, 4}, {8, 16}, {32, 1}, {32, 4}, {32, 16}};
  std::vector<std::array<std::uint32_t, 2>> made;
  for (const std::uint32_t substeps : {8U, 32U, 128U})
    for (const std::uint32_t sweeps : {1U, 4U, 16U, 64U})
      if (substeps * sweeps <= kMostSweeps) made.push_back({substeps, sweeps});
  return made;
}

std::vector<Steps> steps_of(const Method& method, bool is_explicit, bool meets_contact, bool quick) {
  const std::string kind = scene::name_of(method.kind);
  if (is_explicit) return {{kind, "\"auto\"", {}}};
  std::vector<Steps> steps;
  if (!method.sweeps) {
    for (const std::uint32_t substeps : quick ? std::vector{8U} : std::vector{4U, 8U, 16U, 32U})
      steps.push_back({kind + " " + std::to_string(substeps), std::to_string(substeps), {}});
    return steps;
  }
  for (const auto& [substeps, sweeps] : sweeps_of(meets_contact, quick))
    steps.push_back({kind + " " + std::to_string(substeps) + " x " + std::to_string(sweeps),
                     std::to_string(substeps),
                     {{"solver.iterations", std::to_string(sweeps)}}});
  return steps;
}

/// The rows of a scene at one number of nodes.
class MethodRows {
 public:
  MethodRows(const MethodScene& scene, const SheetRuns& runs, std::uint32_t side, const Selection& selection,
             const SheetRowDone& done)
      : scene_(scene),
        runs_(runs),
        side_(side),
        selection_(selection),
        done_(done),
        reference_(runs.run_reference(side)) {}

  Result<void> run(const Method& method) const {
    const std::string kind = scene::name_of(method.kind);
    // Whether a method has a largest step does not depend on the grid; one that refuses the cloth says so in its rows.
    const Result<StepLimit> limit = runs_.step_limit(runs_.sheet().solved_by(4, kind, "1"));
    const bool is_explicit = limit && limit->largest_step > 0;
    for (const Steps& steps : steps_of(method, is_explicit, scene_.meets_contact, selection_.quick)) {
      const SheetRow begun = row_of(steps.variant);
      WEFT_CHECK(report(measure(kind, steps, begun, measuring(is_explicit)), begun, done_));
    }
    return {};
  }

  /// Explicit steps of fewer nodes, drawn by all.
  Result<void> run_null_lines() const {
    for (const std::uint32_t coarse : kCoarseSides) {
      if (coarse >= side_) break;
      SheetRow begun = row_of("null " + std::to_string(coarse));
      const auto [nx, ny] = runs_.sheet().grid(coarse);
      begun.simulated_nodes = std::uint64_t{nx} * ny;
      WEFT_CHECK(report(measure_null(begun, coarse), begun, done_));
    }
    return {};
  }

 private:
  /// The reference's own neighbour, explicit steps of the same grid, is run whatever its frames take.
  Measuring measuring(bool is_neighbour) const {
    return {.kernels = false, .most_ms = is_neighbour ? std::nullopt : selection_.most_ms};
  }

  SheetRow row_of(const std::string& variant) const {
    SheetRow row = begin_row(std::string(scene_.name), variant, side_);
    const auto [nx, ny] = runs_.sheet().grid(side_);
    row.nodes = row.simulated_nodes = std::uint64_t{nx} * ny;
    return row;
  }

  Result<SheetRow> measure(const std::string& kind, const Steps& steps, SheetRow row,
                           const Measuring& measuring) const {
    if (!reference_) return reference_.error();
    std::vector<scene::Override> changes = runs_.sheet().solved_by(side_, kind, steps.substeps);
    changes.insert(changes.end(), steps.settings.begin(), steps.settings.end());
    WEFT_TRY(made, runs_.run(changes, measuring));
    return filled(std::move(row), *reference_, made, made.shapes);
  }

  Result<SheetRow> measure_null(SheetRow row, std::uint32_t coarse) const {
    if (!reference_) return reference_.error();
    WEFT_TRY(made, runs_.run_explicit(coarse, measuring(false)));
    std::vector<SheetShape> drawn;
    for (const SheetShape& shape : made.shapes)
      drawn.push_back(upsampled(made.model, shape, reference_->model));
    return filled(std::move(row), *reference_, made, drawn);
  }

  const MethodScene& scene_;
  const SheetRuns& runs_;
  std::uint32_t side_;
  const Selection& selection_;
  const SheetRowDone& done_;
  Result<SheetRun> reference_;  // of the same grid
};

bool is_asked(const Selection& selection, std::string_view name) {
  if (selection.objects.empty()) return !selection.quick || name == "sheet";
  return std::find(selection.objects.begin(), selection.objects.end(), name) != selection.objects.end();
}

}  // namespace

std::span<const std::string_view> method_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> made;
    for (const Method& method : methods()) made.push_back(scene::name_of(method.kind));
    made.push_back("null");
    return made;
  }();
  return names;
}

std::span<const std::string_view> method_scenes() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> made;
    for (const MethodScene& scene : scenes_of({})) made.push_back(scene.name);
    return made;
  }();
  return names;
}

Result<void> run_methods(gpu::Device& device, const Selection& selection, const Folders& folders,
                         const SheetRowDone& done) {
  for (const MethodScene& scene : scenes_of(selection)) {
    if (!is_asked(selection, scene.name)) continue;
    WEFT_TRY(runs, SheetRuns::create(device, folders, scene.sheet));
    std::vector<std::uint32_t> sides = selection.sides;
    if (sides.empty()) sides = selection.quick ? std::vector{16U} : scene.sides;
    for (const std::uint32_t side : sides) {
      const MethodRows rows(scene, runs, side, selection, done);
      for (const Method& method : methods())
        if (selection.has_variant(scene::name_of(method.kind))) WEFT_CHECK(rows.run(method));
      if (!scene.meets_contact && selection.has_variant("null")) WEFT_CHECK(rows.run_null_lines());
    }
  }
  return {};
}

}  // namespace weft::bench
