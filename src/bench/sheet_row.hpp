#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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
struct SheetRow {
  std::string object;  // "sheet", "fabric", "armadillo", "dragon"
  std::string
      variant;  // "multigrid 8" (substeps), "xpbd 32 x 4" (sweeps), "explicit", "null 64" (nodes along an edge)
  std::uint32_t side = 0;
  std::uint64_t nodes = 0, simulated_nodes = 0;  // fewer are simulated than drawn in null lines
  TimedRun run;
  std::uint32_t reference_substeps = 0;  // 0: nothing is compared
  std::vector<SheetError> errors;
  std::optional<ContactOutcome> contact;  // of rows with something to meet
  std::string state_hash;                 // at the last time that is compared
  std::string skipped;                    // why this row was not run; empty where it was
};

/// Called with each row as it is measured.
using SheetRowDone = std::function<Result<void>(const SheetRow&)>;

SheetRow begin_row(const std::string& object, const std::string& variant, std::uint32_t side);

/// Hands on a row. What a solver or the adapter refuses is a row that says so; other errors end the experiment.
Result<void> report(Result<SheetRow> measured, SheetRow begun, const SheetRowDone& done);

}  // namespace weft::bench
