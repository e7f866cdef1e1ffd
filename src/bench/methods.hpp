#pragma once

#include "bench/pull.hpp"
#include "bench/sheet_row.hpp"

namespace weft::bench {

/// What a selection may ask for: the words of all methods, and "null".
std::span<const std::string_view> method_names();
/// "sheet", "strip", "cantilever", "ball", "armadillo", "twist".
std::span<const std::string_view> method_scenes();

/// Every method on six scenes of one grid: a sheet that falls from two clips, a strip that swings by an end, a clamped
/// strip of fabric that its weight bends, drapes over a ball and the armadillo, and a sheet that is wrung (`quick`: the
/// sheet alone, 16² nodes, to 0.25 s). In as many substeps and sweeps as pay somewhere: explicit steps as "auto" takes
/// them, steps that are stable at any length from 4 to 32 a frame, and methods that sweep from 8 to 128 times 1 to 64.
/// Without contact, also null lines: explicit steps of fewer nodes, drawn finely. Errors are against explicit steps of
/// half the length on the same grid. Each row goes to `done` as it is measured.
/// Errors  Input: a scene or a model is missing. DeviceLost, Shader; what a solver or the adapter refuses, and what
///         takes longer than the selection asks for, is a skipped row.
Result<void> run_methods(gpu::Device& device, const Selection& selection, const Folders& folders,
                         const SheetRowDone& done);

}  // namespace weft::bench
