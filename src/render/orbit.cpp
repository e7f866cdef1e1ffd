#include "render/orbit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace weft::render {

// Nearer to the pole basis_looking takes another axis for up, and the picture would turn over.
constexpr double kHighest = 89 * kDegree;

Camera orbit(const Camera& camera, double dx, double dy) {
  const Vec3d back = camera.eye - camera.target;
  const double azimuth = std::atan2(back.x, back.z) + dx;
  const double elevation =
      std::clamp(std::atan2(back.y, std::hypot(back.x, back.z)) + dy, -kHighest, kHighest);
  const Vec3d turned{std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                     std::cos(azimuth) * std::cos(elevation)};
  return {camera.target + length(back) * turned, camera.target, camera.fov_degrees};
}

Camera pan(const Camera& camera, double dx, double dy) {
  const Basis basis = basis_of(camera);
  const double height = 2 * half_height(camera) * length(camera.eye - camera.target);  // of the picture [m]
  const Vec3d step = -height * (dx * basis.right + dy * basis.up);
  return {camera.eye + step, camera.target + step, camera.fov_degrees};
}

Camera zoom(const Camera& camera, double factor) {
  assert(factor > 0);
  return {camera.target + (camera.eye - camera.target) / factor, camera.target, camera.fov_degrees};
}

}  // namespace weft::render
