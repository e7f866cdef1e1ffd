#pragma once

#include "bench/pull.hpp"
#include "bench/sheet_row.hpp"

namespace weft::bench {

/// The words of all methods, which a selection may ask for.
std::span<const std::string_view> method_names();

/// Every method on the sheet of scenes/sheet.json, of springs that all take, 64² and 256² nodes (`quick`: 16², to
/// 0.25 s, else to 1 s), in as many substeps and sweeps as pay somewhere: explicit steps as "auto" takes them, steps
/// that are stable at any length from 4 to 32 a frame, and methods that sweep from 8 to 128 times 1 to 64. Errors are
/// against explicit steps of half the length on the same grid. Each row goes to `done` as it is measured.
/// Errors  Input: the scene is missing. DeviceLost, Shader; what a solver or the adapter refuses is a skipped row.
Result<void> run_methods(gpu::Device& device, const Selection& selection, const Folders& folders,
                         const SheetRowDone& done);

}  // namespace weft::bench
