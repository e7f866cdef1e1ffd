#pragma once

#include <functional>
#include <optional>

#include "bench/pull.hpp"
#include "bench/sheet_errors.hpp"
#include "bench/timed_run.hpp"

namespace weft::bench {

/// What contact did to cloth in a whole run.
struct ContactOutcome {
  std::uint64_t contacts = 0;                       // hits of all frames
  std::uint32_t crossings = 0, crossings_left = 0;  // the most of any search; of the last
  double max_stretch = 0;                           // at the end of any frame, length / rest length
  std::uint32_t repeated_frames = 0;                // with longer lists; their time is in the row's
};

/// One row: what was run, what a frame took, and how near it came.
struct MultigridRow {
  std::string object;   // "sheet", "fabric", "armadillo", "dragon"
  std::string variant;  // "multigrid 8" (substeps), "explicit", "null 64" (nodes along its edge)
  std::uint32_t side = 0;
  std::uint64_t nodes = 0, simulated_nodes = 0;  // fewer are simulated than drawn in null lines
  TimedRun run;
  std::uint32_t reference_substeps = 0;  // 0: nothing is compared
  std::vector<SheetError> errors;
  std::optional<ContactOutcome> contact;  // of rows with something to meet
  std::string state_hash;                 // at the last time that is compared
  std::string skipped;                    // why this row was not run; empty where it was
};

/// What a selection may ask for: "multigrid" (8 substeps), "multigrid4", "multigrid16", "explicit", "null", "fabric",
/// "drape". Without a selection all but 4 and 16 substeps; `quick` leaves out fabric and drape too.
std::span<const std::string_view> multigrid_variants();

/// The implicit solver on scenes/sheet.json of 64² to 800² nodes (`quick`: 32² and 64² to 0.25 s, else to
/// 1 s), beside explicit steps, and beside the null lines: explicit sheets of fewer nodes, upsampled. Errors
/// are against explicit steps of half the length on the same grid. Then scenes/fabric.json with 8 substeps, up to 256²
/// nodes compared in the same way, and the drapes over armadillo and dragon
/// with self-contact, 256² and 800² nodes. Each row goes to `done` as it is measured.
/// Errors  Input: a scene or model is missing. DeviceLost, Shader; what a solver or the adapter refuses is a
/// skipped row.
Result<void> run_multigrid(gpu::Device& device, const Selection& selection, const Folders& folders,
                           const std::function<Result<void>(const MultigridRow&)>& done);

}  // namespace weft::bench
