// Where a picture is taken from, and where its light comes from.
#pragma once

#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"
#include "render/mat4.hpp"
#include "scene/scene.hpp"

namespace weft::render {

using scene::Camera;

inline constexpr double kDegree = 0.017453292519943295;
/// Half of the picture's height at a distance of 1.
double half_height(const Camera& camera);

/// Three unit vectors of a viewer: right, up and away from what is looked at.
struct Basis {
  Vec3d right, up, back;
};
/// The basis that looks along -`back` with y upward; straight up or down, -z or z is up in the picture.
Basis basis_looking(const Vec3d& back);
Basis basis_of(const Camera& camera);

/// A three-quarter view from a little above that has all of `bounds` in the frame, with a margin of 6 %.
/// Reads   bounds [m] of all that is drawn over the run; aspect: width / height; vertical field of view.
Camera frame_camera(const mesh::Bounds& bounds, double aspect, double fov_degrees = 35);

/// World to clip space, depth 0 at `near` and 1 at `far` [m].
Mat4d view_projection(const Camera& camera, double aspect, double near, double far);

/// World to the clip space of a parallel light from the direction `to_light`, just around `bounds`; the side
/// of one of the map's `texels` comes back too.
struct LightView {
  Mat4d projection;
  double texel = 0;  // [m]
  Vec3d span;        // width, height and depth of the map [m]
};
LightView light_view(const mesh::Bounds& bounds, const Vec3d& to_light, std::uint32_t texels);

/// From above, left of the camera and a little behind it: folds show, and shadows fall to the right.
Vec3d default_light(const Camera& camera);

}  // namespace weft::render
