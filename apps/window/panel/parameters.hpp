#pragma once

#include <map>
#include <string>

#include "player/lists.hpp"
#include "player/player.hpp"

namespace weft::window {

/// The scene's parameters in groups: some change while the cloth moves, the others restart the scene.
class Parameters {
 public:
  explicit Parameters(Player& player) : player_(player) {}

  /// Errors  DeviceLost.
  Result<void> draw();

 private:
  Result<void> draw_group(const ParameterGroup& group);
  Result<void> draw_slider(const Parameter& parameter);
  Result<void> draw_wind(const Parameter& parameter);
  Result<void> draw_number(const Parameter& parameter);
  Result<void> draw_choice(const Parameter& parameter, bool live);
  Result<void> draw_color(const Parameter& parameter);

  Player& player_;
  double heading_ = 0;                        // of the wind, also where it does not blow [degree]
  std::map<std::string, std::string> typed_;  // what is being typed into a field
};

}  // namespace weft::window
