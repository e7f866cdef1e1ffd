#pragma once

#include <functional>

#include "bench/hanging_sheet.hpp"
#include "bench/row.hpp"
#include "bench/selection.hpp"

namespace weft::bench {

/// The paper's first experiment: a sheet of 2 m by 2 m pinned at two corners, in four formulations over
/// grids of 64² to 2048² nodes (`quick`: to 128²), or of the sides selected. Each row goes to `done` as it is
/// measured. Errors  DeviceLost, Shader; what is too large for the adapter is a skipped row.
Result<void> run_hanging(gpu::Device& device, const Selection& selection,
                         const std::function<Result<void>(const Row&)>& done);

}  // namespace weft::bench
