#pragma once

namespace weft::window {

/// When a frame is due. Time that is late by more than a frame is dropped: slower than real time, never a burst.
class Pace {
 public:
  /// So much more time has passed [s]. `frame`: a frame's length [s].
  void pass(double seconds, double frame);
  bool due(double frame) const;
  /// A frame was simulated.
  void take(double frame) { late_ -= frame; }
  /// Until a frame is due [s].
  double until_due(double frame) const;
  /// Time begins now: after a pause, in another scene.
  void begin() { late_ = 0; }
  double dropped() const { return dropped_; }  // [s]

 private:
  double late_ = 0, dropped_ = 0;  // [s]
};

}  // namespace weft::window
