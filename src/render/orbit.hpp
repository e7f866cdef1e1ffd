// A camera as a pointer moves it.
#pragma once

#include "render/camera.hpp"

namespace weft::render {

/// Turns the eye about the target: by `dx` to the right, about the vertical axis, and by `dy` upwards
/// [radian]. The eye keeps its distance and stops a degree short of straight above and below.
Camera orbit(const Camera& camera, double dx, double dy);

/// Moves eye and target so that what lies at the target's depth moves in the picture by `dx` to the right and
/// `dy` upwards, both in heights of the picture.
Camera pan(const Camera& camera, double dx, double dy);

/// Moves the eye along its line to the target, which then looks `factor` times as large.
Camera zoom(const Camera& camera, double factor);

}  // namespace weft::render
