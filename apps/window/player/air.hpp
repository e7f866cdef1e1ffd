// Vectors of a scene as a person sets them: so strong, in this direction. As the page does it
// (apps/web/src/state/air.ts).
#pragma once

#include "base/vec.hpp"

namespace weft::window {

/// `own` made as long as `strength`; down where it has no length.
Vec3d scaled(const Vec3d& own, double strength);
/// Where the wind blows to, about the vertical [degree]: 0 is towards z, 90 towards x.
double heading_of(const Vec3d& wind);
/// A wind of this speed [m/s] and heading [degree] that climbs as `own` does.
Vec3d blowing(double speed, double heading, const Vec3d& own);

}  // namespace weft::window
