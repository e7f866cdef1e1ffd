#pragma once

namespace weft {

/// An inextensible rope that hangs over the upper half of a round rail, with friction: the law of Euler and Eytelwein
/// with the rope's own weight and its motion.
struct RopeOverCapsule {
  double left, right;  // what hangs free [m]
  double radius;       // of the rope's middle [m]
  double friction;
  double gravity;  // [m/s²]

  /// Over the mass per length, so far from where the left end touches, with this acceleration [m²/s²].
  double tension(double angle, double acceleration, double way = 0, double speed = 0) const;
  /// The acceleration of a rope that has slid by `way` [m] and goes at `speed` [m/s], toward the right end [m/s²].
  double acceleration(double way, double speed) const;
  /// How far it slides in a time when it starts at this speed [m]; 0 from rest: friction holds it. Where (g + a) times
  /// what is left of the left end is below the speed's square, a rope leaves the rail there, and this does not hold.
  double way(double time, double speed = 0) const;
};

}  // namespace weft
