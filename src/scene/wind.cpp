#include "scene/wind.hpp"

#include <cmath>

namespace weft::scene {
namespace {

constexpr double kGoldenRatio = 1.618033988749895;  // of the two lengths: the sum of the waves never repeats
constexpr double kAcrossSpeed = 0.5;                // of the second wave, as a part of the wind's
// The waves' push aside and up, as parts of the wind's speed: chosen by eye, so that cloth flutters that
// hangs in the plane of the wind, and none is blown off its course.
constexpr double kAside = 0.35, kLift = 0.2;

/// Horizontal and across `along`; +x where that is upright.
Vec3d aside_of(const Vec3d& along) {
  constexpr double kUpright = 1e-6;  // below it the direction would be made of rounding
  const Vec3d aside = cross(Vec3d{0, 1, 0}, along);
  const double size = length(aside);
  return size > kUpright ? aside / size : Vec3d{1, 0, 0};
}

}  // namespace

WindField wind_field(const Wind& wind) {
  WindField field;
  field.velocity = wind.velocity;
  const double speed = length(wind.velocity);
  if (!(speed > 0)) return {};
  const Vec3d along = wind.velocity / speed;
  const Vec3d aside = aside_of(along);
  const Vec3d up = cross(along, aside);
  const double shorter = wind.wavelength / kGoldenRatio;
  field.waves[0] = {along / wind.wavelength, speed / wind.wavelength,
                    wind.gusts * (0.5 * wind.velocity + kAside * speed * aside)};
  // Oblique, 0.8² + 0.6² = 1, so that neither rows nor columns of a sheet see one phase.
  field.waves[1] = {(0.8 * aside + 0.6 * up) / shorter, kAcrossSpeed * speed / shorter,
                    wind.gusts * (0.5 * wind.velocity + kLift * speed * up)};
  return field;
}

double turn_part(double turns) { return turns - std::floor(turns); }

}  // namespace weft::scene
