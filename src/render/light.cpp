#include "render/light.hpp"

#include <cmath>

#include "render/color_map.hpp"

namespace weft::render {
namespace {

/// What a sky looks like after the tone curve, sRGB made linear.
constexpr Vec3d kSeenHorizon{0.76, 0.84, 0.90}, kSeenZenith{0.20, 0.38, 0.64};
constexpr Vec3d kStudioSun{1.72, 1.63, 1.50}, kSkySun{1.75, 1.58, 1.30};  // irradiance over pi

/// A key light is the sun. Around it: a large soft box above, a cool one from the right, a narrow one from behind.
Surroundings studio(const Camera& camera) {
  const Basis basis = basis_of(camera);
  const auto towards = [&](double right, double up, double back) {
    const Vec3d flat_back = cross(basis.right, Vec3d{0, 1, 0});
    const Vec3d v = right * basis.right + up * Vec3d{0, 1, 0} + back * flat_back;
    return v / length(v);
  };
  return {{0.24, 0.26, 0.29},
          {0.21, 0.22, 0.24},
          {0.15, 0.135, 0.12},
          {{towards(0.1, 1, 0.15), 35 * kDegree, {0.75, 0.78, 0.82}},
           {towards(1, 0.35, 0.5), 25 * kDegree, {0.55, 0.64, 0.78}},
           {towards(0.35, 0.45, -1), 18 * kDegree, {2.0, 1.95, 1.85}}}};
}

Surroundings sky(const Vec3d& to_sun) {
  return {{0.17, 0.29, 0.53},
          {0.32, 0.38, 0.45},
          {0.15, 0.13, 0.11},
          {{to_sun, 25 * kDegree, {0.55, 0.50, 0.42}}}};
}

Vec4f wide(const Vec3d& v, double w) { return Vec4f::from(v.to<float>(), static_cast<float>(w)); }

}  // namespace

// A function of the angle to a direction, in Legendre polynomials sum l_k P_k, has the irradiance over pi
// l_0 + 2/3 l_1 P_1 + 1/4 l_2 P_2 of the normal's angle to it (Ramamoorthi and Hanrahan 2001, eq. 8).
// Level + slope y + curve y^2 is (level + curve / 3) P_0 + slope P_1 + 2/3 curve P_2. An area with cosine c of half its
// angle is (1 - c) / 2 P_0 + 3/4 (1 - c^2) P_1 + 5/4 c (1 - c^2) P_2.
std::array<Vec3d, 9> irradiance_of(const Surroundings& surroundings) {
  std::array<Vec3d, 9> sum{};
  const auto add = [&](const Vec3d& d, const Vec3d& l0, const Vec3d& l1, const Vec3d& l2) {
    const Vec3d linear = 2.0 / 3 * l1, square = 3.0 / 8 * l2;  // 1/4 P_2 = 3/8 cos^2 - 1/8
    sum[0] += l0 - 1.0 / 8 * l2 + d.z * d.z * square;          // z^2 = 1 - x^2 - y^2
    sum[1] += d.x * linear;
    sum[2] += d.y * linear;
    sum[3] += d.z * linear;
    sum[4] += 2 * d.x * d.y * square;
    sum[5] += 2 * d.y * d.z * square;
    sum[6] += 2 * d.z * d.x * square;
    sum[7] += (d.x * d.x - d.z * d.z) * square;
    sum[8] += (d.y * d.y - d.z * d.z) * square;
  };
  const Vec3d slope = 0.5 * (surroundings.zenith - surroundings.ground);
  const Vec3d curve = 0.5 * (surroundings.zenith + surroundings.ground) - surroundings.horizon;
  add({0, 1, 0}, surroundings.horizon + 1.0 / 3 * curve, slope, 2.0 / 3 * curve);
  for (const Area& area : surroundings.areas) {
    const double c = std::cos(area.half_angle), s = 1 - c * c;
    add(area.direction, 0.5 * (1 - c) * area.radiance, 0.75 * s * area.radiance,
        1.25 * c * s * area.radiance);
  }
  return sum;
}

LightParams light_params(const Lighting& lighting, const Camera& camera, const Vec3d& to_sun) {
  const bool outside = lighting.environment == scene::Environment::Sky;
  const Surroundings surroundings = outside ? sky(to_sun) : studio(camera);
  LightParams params;
  params.sun = wide(outside ? kSkySun : kStudioSun, std::tan(0.5 * lighting.sun_degrees * kDegree));
  const std::array<Vec3d, 9> irradiance = irradiance_of(surroundings);
  for (std::size_t k = 0; k < irradiance.size(); ++k) params.irradiance[k] = wide(irradiance[k], 0);
  params.level = wide(surroundings.horizon, 0);
  params.slope = wide(0.5 * (surroundings.zenith - surroundings.ground), 0);
  params.curve = wide(0.5 * (surroundings.zenith + surroundings.ground) - surroundings.horizon, 0);
  for (std::size_t k = 0; k < kAreas; ++k) {
    const Area area = k < surroundings.areas.size() ? surroundings.areas[k] : Area{{0, 1, 0}, 0.1, {}};
    const double cosine = std::cos(area.half_angle);
    params.area_direction[k] = wide(area.direction, cosine);
    params.area_radiance[k] = wide(area.radiance, 1 - cosine);
  }
  params.backdrop_horizon = Vec4f::from(srgb_to_linear(kSeenHorizon.to<float>()), outside ? 1.0F : 0.0F);
  params.backdrop_zenith = Vec4f::from(srgb_to_linear(kSeenZenith.to<float>()), 0);
  return params;
}

}  // namespace weft::render
