// From where a scene is looked at, and what of it is shown.
#pragma once

#include <cstdint>
#include <optional>

#include "weft/vec.hpp"

namespace weft {

struct Camera {
  Vec3d eye, target;        // [m]
  double fov_degrees = 35;  // vertical
};

struct Ray {
  Vec3d origin;     // [m]
  Vec3d direction;  // of any length but 0
};

/// What a picture shows; docs/rendering.md describes each.
enum class View { Textured, Wireframe, Normals, Stretch, Velocity, Contacts };

/// What a world looks like, wherever it is drawn.
struct ViewOptions {
  std::optional<View> view;      // none: the scene's render.view
  std::optional<Camera> camera;  // none: the scene's, or one that has all of it in the frame
};

/// A picture on the host.
struct PictureOptions {
  std::optional<std::uint32_t> width, height;  // [pixel]; none: the scene's render.size
  std::optional<View> view;                    // as ViewOptions::view
  std::optional<Camera> camera;                // as ViewOptions::camera
  bool legend = true;                          // what the colours of a view mean, in the picture's corner
};

/// The place of a cloth that a ray meets first.
struct Picked {
  std::uint32_t cloth = 0;     // in the scene's order, each of a cloth's copies counted
  std::uint32_t triangle = 0;  // of World::triangles()
  std::uint32_t node = 0;      // the corner of the triangle that is nearest to the point
  Vec3d point;                 // [m]
  double distance = 0;         // from the ray's origin [m]
};

}  // namespace weft
