// How a grabbed node is pulled: the same by a kernel and by the reference.
#pragma once

#include "model/model.hpp"

namespace weft {

/// A grabbed node closes in on its target by this part of the distance a second, so to 5 % in 0.15 s: quick
/// under a hand, and slow enough that a hand's jump becomes a pull [1/s].
inline constexpr double kGrabRate = 20;
/// No grabbed node is faster than the larger of these: the speed of a hand [m/s], and, where the scene is large,
/// this many lengths of its largest cloth a second [1/s].
inline constexpr double kGrabSpeed = 10;
inline constexpr double kGrabLengths = 5;

/// The most that a grabbed node of this model may move in a second [m/s].
double grab_speed(const Model& model);

}  // namespace weft
