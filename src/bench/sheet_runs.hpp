#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bench/pull.hpp"
#include "bench/sheet_row.hpp"
#include "method/step_limit.hpp"
#include "model/assets.hpp"
#include "scene/override.hpp"

namespace weft::bench {

/// Frames after which states are compared: 0.25, 0.5 and 1 s; `quick`: the first of them.
std::vector<std::uint32_t> stops_of(const Selection& selection);

/// A scene of one grid, which is run at any number of nodes.
struct SheetOfRuns {
  std::string file;                  // in the folder of scenes, without ".json"
  std::vector<scene::Override> own;  // what is changed in all runs
  std::vector<std::uint32_t> stops;  // frames after which states are compared
  std::uint32_t aspect = 1;          // 1, or 4: four times as many nodes along as across

  /// The grid of side² nodes; `side` is even where the aspect is not 1.
  std::array<std::uint32_t, 2> grid(std::uint32_t side) const;
  /// On this grid by a solver; `substeps` is a number or "auto".
  std::vector<scene::Override> solved_by(std::uint32_t side, const std::string& kind,
                                         const std::string& substeps) const;
};

/// A run of a sheet, and its states at the times that are compared.
struct SheetRun {
  Model model;
  TimedRun run;
  std::vector<SheetShape> shapes;
  std::optional<ContactOutcome> contact;  // where the scene has contact
  std::string state_hash;
};

/// Runs of a sheet by any solver, compared with explicit steps of half the length that these need.
class SheetRuns {
 public:
  /// Errors  Input: its file or a mesh is missing.
  static Result<SheetRuns> create(gpu::Device& device, const Folders& folders, SheetOfRuns sheet);

  const SheetOfRuns& sheet() const { return sheet_; }
  /// The steps that its method can take. Errors  as load_scene.
  Result<StepLimit> step_limit(const std::vector<scene::Override>& changes) const;
  /// The scene with these changes. Errors  as sim::World::create and run_timed.
  Result<SheetRun> run(const std::vector<scene::Override>& changes, const Measuring& measuring = {}) const;
  /// The sheet by explicit steps, as many as "auto" chooses.
  Result<SheetRun> run_explicit(std::uint32_t side, const Measuring& measuring = {}) const;
  /// By twice as many of them.
  Result<SheetRun> run_reference(std::uint32_t side) const;

 private:
  SheetRuns(gpu::Device& device, std::string path, SheetOfRuns sheet, Assets assets)
      : device_(&device), path_(std::move(path)), sheet_(std::move(sheet)), assets_(std::move(assets)) {}

  Result<scene::Scene> load(std::vector<scene::Override> changes) const;

  gpu::Device* device_;
  std::string path_;
  SheetOfRuns sheet_;
  Assets assets_;
};

/// What contact did in a run.
ContactOutcome outcome_of(const sim::Totals& totals);

/// The row with the run's time, and the errors of what was drawn of it.
SheetRow filled(SheetRow row, const SheetRun& reference, const SheetRun& made,
                const std::vector<SheetShape>& drawn);
/// The row with the run's time.
SheetRow timed(SheetRow row, const SheetRun& made);

}  // namespace weft::bench
