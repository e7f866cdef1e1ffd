#pragma once

#include "bench/pull.hpp"
#include "bench/sheet_row.hpp"

namespace weft::bench {

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
                           const SheetRowDone& done);

}  // namespace weft::bench
