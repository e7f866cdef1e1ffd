#pragma once

#include <string>

#include "player/pointer.hpp"

namespace weft::window {

/// What a key does to the picture. `key` is what the page's keys are called: " ", ".", "r", "f", "x", "p", "u", "1" to
/// "6", "+", "-", "Left", "Right", "Up", "Down". False: nothing. Errors  DeviceLost, of what is picked and pinned.
Result<bool> act_on_key(Player& player, const Pointer& pointer, const std::string& key, bool shift);

}  // namespace weft::window
