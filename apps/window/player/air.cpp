#include "player/air.hpp"

#include <cmath>

namespace weft::window {
namespace {

constexpr double kDegree = 0.017453292519943295;

double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }  // no -0

}  // namespace

Vec3d scaled(const Vec3d& own, double strength) {
  const double size = length(own);
  const Vec3d along = size > 0 ? own : Vec3d{0, -1, 0};
  const double factor = strength / (size > 0 ? size : 1);
  return {rounded(along.x * factor), rounded(along.y * factor), rounded(along.z * factor)};
}

double heading_of(const Vec3d& wind) {
  return wind.x == 0 && wind.z == 0 ? 0 : std::round(std::atan2(wind.x, wind.z) / kDegree);
}

Vec3d blowing(double speed, double heading, const Vec3d& own) {
  const double size = length(own);
  const double climb = size > 0 ? own.y / size : 0;
  const double level = speed * std::sqrt(1 - climb * climb);
  return {rounded(level * std::sin(heading * kDegree)), rounded(speed * climb),
          rounded(level * std::cos(heading * kDegree))};
}

}  // namespace weft::window
