// The panel from top to bottom, but for its parameters.
#pragma once

#include "player/commands.hpp"
#include "player/rates.hpp"

namespace weft::window {

// Errors of all  DeviceLost.

/// Play, step, reset, and how fast it goes.
Result<void> draw_transport(Player& player, const Rates& rates);
/// Which scene, by which methods.
Result<void> draw_scene(Player& player, Commands& commands);
/// Views, and the camera.
Result<void> draw_views(Player& player);
Result<void> draw_pins(Player& player);
void draw_readings(Player& player, const Rates& rates);
/// What is saved and recorded.
Result<void> draw_files(Player& player, Commands& commands);

}  // namespace weft::window
