#pragma once

#include <string>
#include <vector>

#include "bench/pull.hpp"
#include "bench/sheet_row.hpp"
#include "method/step_limit.hpp"
#include "scene/override.hpp"

namespace weft::bench {

/// Frames after which states are compared: 0.25, 0.5 and 1 s; `quick`: the first of them.
std::vector<std::uint32_t> stops_of(const Selection& selection);

/// A grid of so many nodes a side and its solver; `substeps` is a number or "auto".
std::vector<scene::Override> solved_by(std::uint32_t side, const std::string& kind,
                                       const std::string& substeps);

/// A run of a sheet, and its states at the times that are compared.
struct SheetRun {
  Model model;
  TimedRun run;
  std::vector<SheetShape> shapes;
  std::string state_hash;
};

/// Runs of a scene of one grid by any solver, compared with explicit steps of half the length that these need.
class SheetRuns {
 public:
  /// `name`: of a file in the folder of scenes; `own`: what is changed in all runs. Errors  Input: it is missing.
  static Result<SheetRuns> create(gpu::Device& device, const Selection& selection, const Folders& folders,
                                  const std::string& name, std::vector<scene::Override> own = {});

  /// The steps that its method can take. Errors  as load_scene.
  Result<StepLimit> step_limit(const std::vector<scene::Override>& changes) const;
  /// The scene with these changes. Errors  as sim::World::create and advance_frame.
  Result<SheetRun> run(const std::vector<scene::Override>& changes) const;
  /// The sheet by explicit steps, as many as "auto" chooses.
  Result<SheetRun> run_explicit(std::uint32_t side) const;
  /// By twice as many of them.
  Result<SheetRun> run_reference(std::uint32_t side) const;

 private:
  SheetRuns(gpu::Device& device, std::string path, std::vector<scene::Override> own,
            std::vector<std::uint32_t> stops)
      : device_(&device), path_(std::move(path)), own_(std::move(own)), stops_(std::move(stops)) {}

  Result<scene::Scene> load(std::vector<scene::Override> changes) const;

  gpu::Device* device_;
  std::string path_;
  std::vector<scene::Override> own_;
  std::vector<std::uint32_t> stops_;
};

/// The row with the run's time, and the errors of what was drawn of it.
SheetRow filled(SheetRow row, const SheetRun& reference, const SheetRun& made,
                const std::vector<SheetShape>& drawn);
/// The row with the run's time.
SheetRow timed(SheetRow row, const SheetRun& made);

}  // namespace weft::bench
