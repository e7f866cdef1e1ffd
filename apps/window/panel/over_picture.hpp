// What lies over the picture. Width and height are the picture's [point].
#pragma once

#include "player/player.hpp"

namespace weft::window {

/// The scene's title, the legend of the view, a marker on each pin, and the rectangle that the pointer draws.
void draw_over_picture(Player& player, float width, float height);
/// The sentence that is said, until it is closed. Errors  DeviceLost.
Result<void> draw_notice(Player& player, float width, float height);
/// What pointer and keys do.
void draw_help(bool& shown, float width, float height);

}  // namespace weft::window
