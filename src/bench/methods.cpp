#include "bench/methods.hpp"

#include "bench/sheet_runs.hpp"
#include "method/method.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr const char* kSheetName = "sheet";
/// Springs that every method takes, of the sheet's own moduli; bend springs instead of its bending [N/m].
const scene::Override kSprings = {"cloths.0.stiffness", R"({"structural": 1500, "shear": 750, "bend": 15})"};

/// Of a frame: more take five times its length and longer on any GPU.
constexpr std::uint32_t kMostSweeps = 1024;

/// How a method steps in a row.
struct Steps {
  std::string variant, substeps;
  std::vector<scene::Override> settings;  // of the solver
};

std::vector<Steps> steps_of(const Method& method, bool is_explicit, bool quick) {
  const std::string kind = scene::name_of(method.kind);
  if (is_explicit) return {{kind, "\"auto\"", {}}};
  std::vector<Steps> steps;
  if (!method.sweeps) {
    for (const std::uint32_t substeps : quick ? std::vector{8U} : std::vector{4U, 8U, 16U, 32U})
      steps.push_back({kind + " " + std::to_string(substeps), std::to_string(substeps), {}});
    return steps;
  }
  for (const std::uint32_t substeps : quick ? std::vector{8U} : std::vector{8U, 32U, 128U})
    for (const std::uint32_t sweeps : quick ? std::vector{4U} : std::vector{1U, 4U, 16U, 64U}) {
      if (substeps * sweeps > kMostSweeps) break;
      steps.push_back({kind + " " + std::to_string(substeps) + " x " + std::to_string(sweeps),
                       std::to_string(substeps),
                       {{"solver.iterations", std::to_string(sweeps)}}});
    }
  return steps;
}

/// Measures the method in these steps. `reference`: of the same grid.
Result<SheetRow> measure(const SheetRuns& runs, const Method& method, const Steps& steps,
                         const Result<SheetRun>& reference, SheetRow row) {
  if (!reference) return reference.error();
  std::vector<scene::Override> changes = solved_by(row.side, scene::name_of(method.kind), steps.substeps);
  changes.insert(changes.end(), steps.settings.begin(), steps.settings.end());
  WEFT_TRY(made, runs.run(changes));
  return filled(std::move(row), *reference, made, made.shapes);
}

}  // namespace

std::span<const std::string_view> method_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> made;
    for (const Method& method : methods()) made.push_back(scene::name_of(method.kind));
    return made;
  }();
  return names;
}

Result<void> run_methods(gpu::Device& device, const Selection& selection, const Folders& folders,
                         const SheetRowDone& done) {
  WEFT_TRY(runs, SheetRuns::create(device, selection, folders, kSheetName, {kSprings}));
  std::vector<std::uint32_t> sides = selection.sides;
  if (sides.empty() && selection.quick) sides = {16};
  if (sides.empty()) sides = {64, 256};
  for (const std::uint32_t side : sides) {
    const Result<SheetRun> reference = runs.run_reference(side);
    for (const Method& method : methods()) {
      if (!selection.has_variant(scene::name_of(method.kind))) continue;
      // Whether a method has a largest step does not depend on the grid.
      WEFT_TRY(limit, runs.step_limit(solved_by(4, scene::name_of(method.kind), "1")));
      for (const Steps& steps : steps_of(method, limit.largest_step > 0, selection.quick)) {
        const SheetRow begun = begin_row(kSheetName, steps.variant, side);
        WEFT_CHECK(report(measure(runs, method, steps, reference, begun), begun, done));
      }
    }
  }
  return {};
}

}  // namespace weft::bench
