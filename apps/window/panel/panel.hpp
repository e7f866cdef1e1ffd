// The panel beside the picture, by Dear ImGui: what the page's panel has, by the same names.
#pragma once

#include "panel/parameters.hpp"
#include "player/commands.hpp"
#include "player/rates.hpp"

namespace weft::window {

class Panel {
 public:
  Panel(Player& player, Commands& commands) : player_(player), commands_(commands), parameters_(player) {}

  /// Lays out the panel and what lies over the picture, in a window of this size [Dear ImGui's units].
  /// Errors  DeviceLost.
  Result<void> draw(float width, float height);
  void toggle_theme() { dark_ = !dark_; }
  void toggle_help() { help_ = !help_; }
  bool dark() const { return dark_; }
  Rates rates;

 private:
  Player& player_;
  Commands& commands_;
  Parameters parameters_;
  bool dark_ = true, help_ = false;
};

}  // namespace weft::window
