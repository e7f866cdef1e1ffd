#pragma once

#include <functional>

#include "bench/hanging_sheet.hpp"
#include "bench/measure.hpp"
#include "bench/selection.hpp"

namespace weft::bench {

/// The largest sheet that fits in a device's limits.
struct LargestRow {
  std::string limits;   // "default": WebGPU's; "adapter": all that the adapter has
  std::string variant;  // formulation
  std::uint32_t side = 0;
  std::uint64_t nodes = 0;
  std::string limited_by;       // the limit's name and value: what refuses side + 1
  std::uint64_t gpu_bytes = 0;  // that its world holds
  Timing step;                  // ms
  std::string skipped;          // why it was not run, and `side` is worked out from smaller ones; else empty
};

/// What may be spent on seeing whether a size fits.
struct Budget {
  std::uint64_t bytes = 0;  // of host memory; on a software adapter the GPU's are the host's
  double seconds = 60;      // to build a world
};

/// Finds it by making worlds, then runs it. `limits` is the row's.
/// Errors  Diverged, DeviceLost. Limit: not even 32 x 32 nodes fit.
Result<LargestRow> measure_largest(gpu::Device& device, Formulation formulation, const std::string& limits,
                                   const Budget& budget);

/// The largest hanging sheet of each formulation, in WebGPU's default limits and in the adapter's.
/// Errors  NoAdapter, and those of measure_largest.
Result<void> run_largest(gpu::DeviceOptions options, const Selection& selection, const Budget& budget,
                         const std::function<Result<void>(const LargestRow&)>& done);

}  // namespace weft::bench
