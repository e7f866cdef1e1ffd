// The light of a picture: a sun, and surroundings in closed form.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "render/camera.hpp"

namespace weft::render {

inline constexpr std::size_t kAreas = 3;

/// Mirror of Light in src/render/surroundings.wgsl.
struct LightParams {
  Vec4f sun;                                   // irradiance over pi; w: tangent of half the sun's angle
  std::array<Vec4f, 9> irradiance{};           // over pi: factors of 1, x, y, z, xy, yz, zx, xx, yy
  Vec4f level, slope, curve;                   // radiance by the direction's y
  std::array<Vec4f, kAreas> area_direction{};  // unit; w: cosine of half the angle that the area covers
  std::array<Vec4f, kAreas> area_radiance{};   // w: 1 - that cosine
  Vec4f backdrop_horizon;  // linear; w: 1 where a sky is seen, 0 for the studio's backdrop
  Vec4f backdrop_zenith;
};
static_assert(sizeof(LightParams) == 336);

/// A round part of the surroundings that shines more than what is behind it.
struct Area {
  Vec3d direction;        // unit
  double half_angle = 0;  // [radian]
  Vec3d radiance;         // beside what is behind it
};

/// Radiance from every direction: a square of the direction's y, equal to these three above, level and below, and
/// areas.
struct Surroundings {
  Vec3d zenith, horizon, ground;
  std::vector<Area> areas;  // kAreas at most
};

/// The irradiance over pi on a unit normal as factors of 1, x, y, z, xy, yz, zx, xx, yy: what spherical harmonics of
/// the second order have of it. Of zenith, horizon and ground it is exact.
std::array<Vec3d, 9> irradiance_of(const Surroundings& surroundings);

struct Lighting {
  scene::Environment environment = scene::Environment::Studio;
  double sun_degrees = 3;  // the angle that the sun covers
};
/// Reads  camera: where the studio's areas are put around; to_sun: unit.
LightParams light_params(const Lighting& lighting, const Camera& camera, const Vec3d& to_sun);

}  // namespace weft::render
