#include "bench/sheet_runs.hpp"

#include "method/method.hpp"
#include "model/attachments.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr const char* kExplicit = "mass_spring";

}  // namespace

std::vector<std::uint32_t> stops_of(const Selection& selection) {
  return selection.quick ? std::vector<std::uint32_t>{15} : std::vector<std::uint32_t>{15, 30, 60};
}

std::array<std::uint32_t, 2> SheetOfRuns::grid(std::uint32_t side) const {
  if (aspect == 1) return {side, side};
  return {2 * side, side / 2};
}

std::vector<scene::Override> SheetOfRuns::solved_by(std::uint32_t side, const std::string& kind,
                                                    const std::string& substeps) const {
  const auto [nx, ny] = grid(side);
  return {{"cloths.0.grid", "[" + std::to_string(nx) + "," + std::to_string(ny) + "]"},
          scene::override_solver(kind),
          {"time.substeps", substeps}};
}

ContactOutcome outcome_of(const sim::Totals& totals) {
  return {totals.contacts, totals.crossings, totals.crossings_left, static_cast<double>(totals.max_stretch),
          totals.repeated_frames};
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
  row.contact = made.contact;
  return row;
}

SheetRow filled(SheetRow row, const SheetRun& reference, const SheetRun& made,
                const std::vector<SheetShape>& drawn) {
  row = timed(std::move(row), made);
  row.reference_substeps = reference.run.substeps;
  row.errors = sheet_errors(reference.model, drawn, reference.shapes);
  return row;
}

Result<SheetRuns> SheetRuns::create(gpu::Device& device, const Folders& folders, SheetOfRuns sheet) {
  std::string path = folders.scenes + "/" + sheet.file + ".json";
  WEFT_TRY(scene, scene::load_scene(path));  // a missing file is no skipped row
  WEFT_TRY(assets, load_assets(scene, folders.models));
  return SheetRuns(device, std::move(path), std::move(sheet), std::move(assets));
}

Result<scene::Scene> SheetRuns::load(std::vector<scene::Override> changes) const {
  changes.insert(changes.begin(), sheet_.own.begin(), sheet_.own.end());
  return scene::load_scene(path_, changes);
}

Result<StepLimit> SheetRuns::step_limit(const std::vector<scene::Override>& changes) const {
  WEFT_TRY(scene, load(changes));
  WEFT_TRY(model, build_model(scene, assets_));
  return method_of(scene.solver.kind).step_limit(scene, model);
}

Result<SheetRun> SheetRuns::run(const std::vector<scene::Override>& changes,
                                const Measuring& measuring) const {
  WEFT_TRY(scene, load(changes));
  SheetRun made;
  WEFT_TRY(model, build_model(scene, assets_));
  made.model = std::move(model);
  WEFT_TRY(run, run_timed(*device_, scene, assets_, sheet_.stops, measuring));
  made.run = std::move(run);
  if (scene.contact.method != scene::ContactMethod::None) made.contact = outcome_of(made.run.totals);
  for (std::size_t k = 0; k < sheet_.stops.size(); ++k)
    made.shapes.push_back(shape_of(made.model, made.run.states[k], sheet_.stops[k] * scene.time.frame));
  made.state_hash = made.run.states.back().hash();
  made.run.states.clear();  // the shapes have what is needed of them
  return made;
}

Result<SheetRun> SheetRuns::run_explicit(std::uint32_t side, const Measuring& measuring) const {
  return run(sheet_.solved_by(side, kExplicit, "\"auto\""), measuring);
}

Result<SheetRun> SheetRuns::run_reference(std::uint32_t side) const {
  WEFT_CHECK(sim::check_node_count(static_cast<std::uint64_t>(side) * side, *device_));
  WEFT_TRY(scene, load(sheet_.solved_by(side, kExplicit, "\"auto\"")));
  WEFT_TRY(substeps, count_substeps(scene, assets_));
  return run(sheet_.solved_by(side, kExplicit, std::to_string(2 * substeps)), {.kernels = false});
}

}  // namespace weft::bench
