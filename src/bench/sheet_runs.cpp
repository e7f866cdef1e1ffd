#include "bench/sheet_runs.hpp"

#include "method/method.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr const char* kExplicit = "mass_spring";

}  // namespace

std::vector<std::uint32_t> stops_of(const Selection& selection) {
  return selection.quick ? std::vector<std::uint32_t>{15} : std::vector<std::uint32_t>{15, 30, 60};
}

std::vector<scene::Override> solved_by(std::uint32_t side, const std::string& kind,
                                       const std::string& substeps) {
  const std::string count = std::to_string(side);
  return {{"cloths.0.grid", "[" + count + "," + count + "]"},
          scene::override_solver(kind),
          {"time.substeps", substeps}};
}

SheetRow begin_row(const std::string& object, const std::string& variant, std::uint32_t side) {
  SheetRow row;
  row.object = object;
  row.variant = variant;
  row.side = side;
  row.nodes = row.simulated_nodes = static_cast<std::uint64_t>(side) * side;
  return row;
}

Result<void> report(Result<SheetRow> measured, SheetRow begun, const SheetRowDone& done) {
  if (measured) return done(*measured);
  if (!skips_row(measured.error()) && measured.error().kind != ErrorKind::Input) return measured.error();
  begun.skipped = measured.error().message;
  return done(begun);
}

SheetRow timed(SheetRow row, const SheetRun& made) {
  row.run = made.run;
  row.state_hash = made.state_hash;
  return row;
}

SheetRow filled(SheetRow row, const SheetRun& reference, const SheetRun& made,
                const std::vector<SheetShape>& drawn) {
  row = timed(std::move(row), made);
  row.reference_substeps = reference.run.substeps;
  row.errors = sheet_errors(reference.model, drawn, reference.shapes);
  return row;
}

Result<SheetRuns> SheetRuns::create(gpu::Device& device, const Selection& selection, const Folders& folders,
                                    const std::string& name, std::vector<scene::Override> own) {
  SheetRuns runs(device, folders.scenes + "/" + name + ".json", std::move(own), stops_of(selection));
  WEFT_TRY(scene, scene::load_scene(runs.path_));  // a missing file is no skipped row
  return runs;
}

Result<scene::Scene> SheetRuns::load(std::vector<scene::Override> changes) const {
  changes.insert(changes.begin(), own_.begin(), own_.end());
  return scene::load_scene(path_, changes);
}

Result<StepLimit> SheetRuns::step_limit(const std::vector<scene::Override>& changes) const {
  WEFT_TRY(scene, load(changes));
  WEFT_TRY(model, build_model(scene, {{}}));
  return method_of(scene.solver.kind).step_limit(scene, model);
}

Result<SheetRun> SheetRuns::run(const std::vector<scene::Override>& changes) const {
  WEFT_TRY(scene, load(changes));
  const Assets assets{{{}}};  // a grid comes from no file
  SheetRun made;
  WEFT_TRY(model, build_model(scene, assets.cloths));
  made.model = std::move(model);
  WEFT_TRY(run, run_timed(*device_, scene, assets, stops_));
  made.run = std::move(run);
  for (std::size_t k = 0; k < stops_.size(); ++k)
    made.shapes.push_back(shape_of(made.model, made.run.states[k], stops_[k] * scene.time.frame));
  made.state_hash = made.run.states.back().hash();
  made.run.states.clear();  // the shapes have what is needed of them
  return made;
}

Result<SheetRun> SheetRuns::run_explicit(std::uint32_t side) const {
  return run(solved_by(side, kExplicit, "\"auto\""));
}

Result<SheetRun> SheetRuns::run_reference(std::uint32_t side) const {
  WEFT_CHECK(sim::check_node_count(static_cast<std::uint64_t>(side) * side, *device_));
  WEFT_TRY(scene, load(solved_by(side, kExplicit, "\"auto\"")));
  WEFT_TRY(substeps, count_substeps(scene, {{{}}}));
  return run(solved_by(side, kExplicit, std::to_string(2 * substeps)));
}

}  // namespace weft::bench
