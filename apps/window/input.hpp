#pragma once

#include "panel/panel.hpp"
#include "player/commands.hpp"
#include "player/pointer.hpp"
#include "toolkit.hpp"

namespace weft::window {

/// What GLFW hears, for the picture: keys, mouse, files that are dropped. Dear ImGui takes what the panel hears.
class Input {
 public:
  Input(const Toolkit& toolkit, Player& player, Commands& commands, Panel& panel)
      : toolkit_(toolkit), player_(player), commands_(commands), panel_(panel), pointer_(player) {}

  /// Listens to the window from now on; it must stay where it is.
  void listen();
  /// Takes what has come, waiting for it at most so long [s]. Errors  DeviceLost.
  Result<void> take(double wait);
  /// Brings what the hand holds to where the pointer is; once a picture. Errors  DeviceLost.
  Result<void> move_hand() { return player_.said(pointer_.update()); }

 private:
  void on_key(int key, int action, int modifiers);
  void on_letter(unsigned int code);
  void on_button(int button, int action, int modifiers);
  void on_move(double x, double y);
  void on_wheel(double notches);
  void on_drop(const std::vector<std::string>& paths);
  /// A key while it is asked what a mesh is to be.
  void answer(int key);
  bool over_picture() const;
  void act(const std::string& key, bool shift);
  /// Says what has gone wrong, and keeps what ends the window.
  void keep(const Result<void>& done);

  const Toolkit& toolkit_;
  Player& player_;
  Commands& commands_;
  Panel& panel_;
  Pointer pointer_;
  bool repeated_ = false;  // the key that is down has been heard before
  Result<void> failed_;    // in a callback
};

}  // namespace weft::window
