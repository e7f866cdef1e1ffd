#pragma once

#include <string>

#include "bench/sheet_row.hpp"
#include "model/assets.hpp"

namespace weft::bench {

/// `begun` with a whole run of a scene, up to its last frame; nothing is compared.
/// Errors  as sim::World::create and run_timed.
Result<SheetRow> measure_scene(gpu::Device& device, const scene::Scene& scene, const Assets& assets,
                               SheetRow begun);

/// A scene of any cloths and bodies: `name` is the row's object, the word of the solver that ran its variant. The row
/// goes to `done`; what the solver or the adapter refuses is a skipped one.
/// Errors  DeviceLost, Shader; those of `done`.
Result<void> run_scene(gpu::Device& device, const std::string& name, const scene::Scene& scene,
                       const Assets& assets, const SheetRowDone& done);

}  // namespace weft::bench
