#include <doctest/doctest.h>

#include "render/cloth_surface.hpp"
#include "render/floor.hpp"

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

TEST_CASE("cloths without a colour get different ones") {
  const ClothRange plain;
  CHECK_FALSE(weave_of(plain, 0).base == weave_of(plain, 1).base);
  ClothRange red;
  red.color = Vec3d{1, 0, 0};
  CHECK(weave_of(red, 0).base.x == doctest::Approx(1));
  CHECK(weave_of(red, 0).base.y == doctest::Approx(0));
  ClothRange body = red;
  body.woven = false;
  const WeaveParams even = weave_of(body, 0);
  CHECK(even.base.xyz() == weave_of(red, 0).base.xyz());
  CHECK(even.dark.xyz() == even.base.xyz());
  CHECK(even.accent.xyz() == even.base.xyz());
  CHECK(even.back.w == 0);
}
