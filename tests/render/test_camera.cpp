#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.hpp"
#include "render/camera.hpp"

using namespace weft;
using namespace weft::render;

namespace {

Vec3d corner(const mesh::Bounds& bounds, int i) {
  return {(i & 1) != 0 ? bounds.high.x : bounds.low.x, (i & 2) != 0 ? bounds.high.y : bounds.low.y,
          (i & 4) != 0 ? bounds.high.z : bounds.low.z};
}

mesh::Bounds random_box(Random& random) {
  mesh::Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = static_cast<float>(random.uniform(-5, 5));
    box.high[axis] = box.low[axis] + static_cast<float>(random.below(8) == 0 ? 0 : random.uniform(0.001, 4));
  }
  return box;
}

}  // namespace

TEST_CASE("a framed camera has all corners of a box in its frame, and one of them near its rim") {
  Random random(7);
  for (int round = 0; round < 2000; ++round) {
    const mesh::Bounds box = random_box(random);
    const double aspect = random.uniform(0.3, 3.5), fov = random.uniform(15, 80);
    const Camera camera = frame_camera(box, aspect, fov);
    const Mat4d projection = view_projection(camera, aspect, 0.01, 1000);
    double farthest = 0;
    for (int i = 0; i < 8; ++i) {
      const auto clip = projection.apply(corner(box, i));
      REQUIRE(clip[3] > 0);
      farthest = std::max({farthest, std::abs(clip[0] / clip[3]), std::abs(clip[1] / clip[3])});
    }
    CAPTURE(round);
    CHECK(farthest < 1);
    const Vec3f size = box.high - box.low;
    if (std::min({size.x, size.y, size.z}) < 0.2F || fov > 50)
      continue;                                    // where the eye keeps off the box itself
    CHECK(farthest == doctest::Approx(1 / 1.06));  // the margin
  }
}

TEST_CASE("a box without extent is framed from nearby") {
  const Camera camera = frame_camera({{1, 2, 3}, {1, 2, 3}}, 1.5);
  CHECK(length(camera.eye - Vec3d{1, 2, 3}) == doctest::Approx(1e-3));
}

TEST_CASE("the projection puts near at depth 0, far at 1, and up above right of the middle") {
  const Camera camera{{0, 0, 5}, {0, 0, 0}, 90};
  const Mat4d projection = view_projection(camera, 2, 1, 9);
  const auto near = projection.apply({0, 0, 4}), far = projection.apply({0, 0, -4}),
             rim = projection.apply({10, 5, 0});
  CHECK(near[2] / near[3] == doctest::Approx(0));
  CHECK(far[2] / far[3] == doctest::Approx(1));
  CHECK(rim[0] / rim[3] == doctest::Approx(1));  // tan 45 degrees = 1, aspect 2
  CHECK(rim[1] / rim[3] == doctest::Approx(1));
}

TEST_CASE("a viewer's axes are unit vectors at right angles, right-handed, also straight up and down") {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const Vec3d back = round == 0 ? Vec3d{0, 1, 0}
                       : round == 1
                           ? Vec3d{0, -1, 0}
                           : Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const Basis basis = basis_looking(back);
    CHECK(length(cross(basis.right, basis.up) - basis.back) == doctest::Approx(0));
    CHECK(length(basis.right) == doctest::Approx(1));
    CHECK(dot(basis.back, back) == doctest::Approx(length(back)));
  }
}

TEST_CASE("the sun's view holds a box exactly, with depth growing away from the sun") {
  Random random(11);
  for (int round = 0; round < 500; ++round) {
    const mesh::Bounds box = random_box(random);
    const Vec3d to_light{random.uniform(-1, 1), random.uniform(0.1, 1), random.uniform(-1, 1)};
    const LightView light = light_view(box, to_light, 1000);
    CHECK(light.texel > 0);
    for (int i = 0; i < 8; ++i) {
      const auto clip = light.projection.apply(corner(box, i));
      CHECK(clip[3] == 1);
      CHECK(std::abs(clip[0]) <= 1);
      CHECK(std::abs(clip[1]) <= 1);
      CHECK(clip[2] >= 0);
      CHECK(clip[2] <= 1);
      const Vec3d nearer = corner(box, i) + 0.1 * to_light;
      CHECK(light.projection.apply(nearer)[2] < clip[2]);
    }
  }
}
