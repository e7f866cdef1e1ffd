// The hand that holds the cloth. It goes after the pointer, but its speed in simulated time is bounded by the pointer's
// in real time: on a machine that simulates a twentieth of real time, a pull of a third of a second lasts some seconds,
// and does not tear the cloth away within a frame. The page's hand (apps/web/src/hand.ts) does the same.
#pragma once

#include <deque>

namespace weft::window {

/// [pixel]
struct Place {
  double x = 0, y = 0;
};
double distance(const Place& a, const Place& b);

class Hand {
 public:
  Hand() = default;
  explicit Hand(const Place& place) : place_(place), pointer_(place) {}

  /// Whether it is where the pointer is.
  bool arrived() const { return distance(place_, pointer_) == 0; }
  /// The pointer has come to a place; `at`: when [s].
  void follow(const Place& to, double at);
  /// Where it is after so much more simulated time [s]; infinity: with the pointer.
  Place after(double seconds);

 private:
  struct Move {
    double at = 0, way = 0;
  };

  Place place_, pointer_;
  std::deque<Move> moves_;  // of the pointer, within the window
  double speed_ = 0;        // the highest allowed since the hand was where the pointer is [pixel/s]
};

}  // namespace weft::window
