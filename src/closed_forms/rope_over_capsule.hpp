#pragma once

namespace weft {

/// An inextensible rope that hangs over the upper half of a round rail, with friction: the law of Euler and Eytelwein
/// with the rope's own weight and its motion.
struct RopeOverCapsule {
  double left, right;  // what hangs free [m]
  double radius;       // of the rope's middle [m]
  double friction;
  double gravity;  // [m/s²]

  /// The acceleration of a rope that has slid by `way` [m] and goes at `speed` [m/s], toward the right end [m/s²].
  double acceleration(double way, double speed) const;
  /// How far it slides in a time when it starts at rest [m]; 0: friction holds it.
  double way(double time) const;
};

}  // namespace weft
