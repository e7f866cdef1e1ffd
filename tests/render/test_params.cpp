#include <doctest/doctest.h>

#include <cmath>

#include "render/fabric.hpp"
#include "render/floor.hpp"
#include "render/light.hpp"
#include "scene/looks.hpp"

using namespace weft;
using namespace weft::render;

TEST_CASE("a floor's axes are unit, at right angles, and turn to its normal") {
  for (const Vec3d& normal : {Vec3d{0, 1, 0}, Vec3d{1, 0, 0}, Vec3d{0.3, 2, -0.4}, Vec3d{-1, 0.1, 0}}) {
    const PlaneParams plane = plane_params({{1, 2, 3}, normal}, {4, 5, 6}, 10, false);
    const Vec3d along = plane.along.xyz().to<double>(), across = plane.across.xyz().to<double>();
    const Vec3d unit = normal / length(normal);
    CHECK(length(cross(along, across) - unit) < 1e-6);
    CHECK(length(along) == doctest::Approx(1));
    CHECK(dot(plane.center.xyz().to<double>() - Vec3d{1, 2, 3}, unit) == doctest::Approx(0).epsilon(1e-6));
  }
}

TEST_CASE("cloths without a colour get different ones, and a look's own goes before them") {
  const ClothRange plain;
  CHECK_FALSE(fabric_of(plain, 0).warp == fabric_of(plain, 1).warp);
  ClothRange red;
  red.color = Vec3d{1, 0, 0};
  CHECK(fabric_of(red, 0).warp.x == doctest::Approx(1));
  CHECK(fabric_of(red, 0).warp.y == doctest::Approx(0));
  CHECK(fabric_of(red, 0).tint.xyz() == fabric_of(red, 0).warp.xyz());
  ClothRange denim;
  denim.look = scene::look_of("denim");
  CHECK(fabric_of(denim, 0).warp.xyz() == fabric_of(denim, 1).warp.xyz());
  CHECK(fabric_of(denim, 0).weft.x > 4 * fabric_of(denim, 0).warp.x);  // white through indigo
  denim.color = red.color;
  CHECK(fabric_of(denim, 0).warp.xyz() == fabric_of(red, 0).warp.xyz());
}

TEST_CASE("what is closed is of one colour, without threads, pattern and hem") {
  ClothRange body;
  body.color = Vec3d{1, 0, 0};
  body.woven = false;
  const FabricParams even = fabric_of(body, 0);
  CHECK(even.weft.xyz() == even.warp.xyz());
  CHECK(even.weave == static_cast<std::uint32_t>(scene::Weave::None));
  CHECK(even.pattern == static_cast<std::uint32_t>(scene::Pattern::Plain));
  CHECK(even.back.w == 0);
  CHECK(even.rim.z == 0);
}

TEST_CASE("threads are as many a centimetre as a look says, and a hem is no wider than 12 mm") {
  ClothRange range;
  range.look = scene::look_of("cotton");
  range.rim = {2.0, 1.0};
  CHECK(fabric_of(range, 0).warp.w == doctest::Approx(0.01 / 28));
  CHECK(fabric_of(range, 0).rim.z == doctest::Approx(0.012));
  range.rim = {0.2, 0.1};
  CHECK(fabric_of(range, 0).rim.z == doctest::Approx(0.003));
  range.look = scene::look_of("paper");
  CHECK(fabric_of(range, 0).rim.z == 0);
}

TEST_CASE("the surroundings' irradiance equals its integral over the half space") {
  const Surroundings surroundings = {
      {0.4, 0.5, 0.9},
      {0.6, 0.5, 0.4},
      {0.2, 0.3, 0.1},
      {{{0.6, 0.64, 0.48}, 0.9, {2, 1, 0.5}}, {{-0.48, 0.6, -0.64}, 0.7, {0.3, 0.8, 1}}}};
  const std::array<Vec3d, 9> e = irradiance_of(surroundings);
  const auto radiance = [&](const Vec3d& d) {
    const Vec3d slope = 0.5 * (surroundings.zenith - surroundings.ground);
    const Vec3d curve = 0.5 * (surroundings.zenith + surroundings.ground) - surroundings.horizon;
    Vec3d sum = surroundings.horizon + d.y * slope + d.y * d.y * curve;
    for (const Area& area : surroundings.areas)
      if (dot(d, area.direction) > std::cos(area.half_angle)) sum += area.radiance;
    return sum;
  };
  for (const Vec3d& n : {Vec3d{0, 1, 0}, Vec3d{0, -1, 0}, Vec3d{0.6, 0.64, 0.48}, Vec3d{-0.48, 0.6, -0.64},
                         Vec3d{0.8, 0, -0.6}}) {
    Vec3d integral;  // over pi, by the middles of 400 x 400 equal parts of the sphere
    const int parts = 400;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const double y = -1 + (2 * i + 1.0) / parts, turn = 2 * 3.14159265358979 * (j + 0.5) / parts;
        const double r = std::sqrt(1 - y * y);
        const Vec3d d{r * std::cos(turn), y, r * std::sin(turn)};
        integral += 4.0 / (parts * parts) * std::max(0.0, dot(n, d)) * radiance(d);
      }
    const Vec3d closed = e[0] + n.x * e[1] + n.y * e[2] + n.z * e[3] + n.x * n.y * e[4] + n.y * n.z * e[5] +
                         n.z * n.x * e[6] + n.x * n.x * e[7] + n.y * n.y * e[8];
    // What the second order leaves of areas is below 9 % of a hemisphere's (Ramamoorthi and Hanrahan 2001).
    CHECK(length(closed - integral) < 0.06 * length(integral));
  }
  const std::array<Vec3d, 9> gradient =
      irradiance_of({{0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}, {0.2, 0.2, 0.2}, {}});
  CHECK(gradient[0].x + gradient[2].x + gradient[8].x == doctest::Approx(0.6 - 0.3 / 2 + 0.1 * 2 / 3));
}
