// From where a scene is looked at, and what of it is shown.
#pragma once

#include "weft/vec.hpp"

namespace weft {

struct Camera {
  Vec3d eye, target;        // [m]
  double fov_degrees = 35;  // vertical
};

/// What a picture shows; docs/rendering.md describes each.
enum class View { Textured, Wireframe, Normals, Stretch, Velocity, Contacts };

}  // namespace weft
