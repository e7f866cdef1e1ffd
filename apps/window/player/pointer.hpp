// The mouse on the picture, as the page has it. The left button takes hold of the cloth or, beside it, turns the
// camera, and pressed twice it pins; with Control it draws a rectangle, all under which is pinned; the right one, or
// Shift, moves the picture; the wheel zooms.
#pragma once

#include <optional>
#include <vector>

#include "player/hand.hpp"
#include "player/player.hpp"

namespace weft::window {

/// Places are pixels of the picture, from its top left corner; times are seconds of the window's clock.
class Pointer {
 public:
  explicit Pointer(Player& player) : player_(player) {}

  enum class Button { Left, Other };
  /// Errors  DeviceLost, of what is picked and grabbed.
  Result<void> press(Button button, bool shift, double at);
  /// Begins a rectangle, which ends where the button is released.
  void begin_area();
  Result<void> release();
  void move(const Place& to, double at);
  void wheel(double notches);
  /// Brings what is held to where the pointer is; once a picture.
  Result<void> update();

  /// The node that the hand holds.
  std::optional<std::uint32_t> held() const { return pull_ ? std::optional(pull_->node) : std::nullopt; }
  /// Where the pointer is: x to the right and y upwards, each from -1 to 1.
  Place clip() const { return clip(place_); }

 private:
  /// A node that the hand draws.
  struct Pull {
    std::uint32_t node = 0;
    Vec3d point;  // where it was taken hold of: the hand stays as far from the camera [m]
    Hand hand;
    double seconds = 0;  // up to which simulated time the hand has moved
  };
  enum class Gesture { None, Pull, Orbit, Pan, Area };

  Result<void> take_hold();
  Result<void> draw(Pull& pull);
  bool held_in_world(std::uint32_t node) const;
  double simulated() const;  // [s]
  double height() const;
  Place clip(const Place& pixel) const;

  Player& player_;
  Gesture gesture_ = Gesture::None;
  Place place_, last_;  // of the pointer; up to where the camera has followed, or where the rectangle began
  std::optional<Pull> pull_;
  std::vector<Pull> trailing_;  // pins that the pointer has left before the hand was there
  double pressed_ = -1;         // when the left button went down last
  Place pressed_place_;
};

}  // namespace weft::window
