#include <doctest/doctest.h>

#include <cmath>

#include "base/random.hpp"
#include "render/orbit.hpp"
#include "render/pick.hpp"

using namespace weft;
using namespace weft::render;

namespace {

constexpr double kTurn = 6.283185307179586;  // radian

Vec3d random_point(Random& random) {
  return {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
}

/// Not within 8 degrees of the poles, where an eye must not be.
Camera random_camera(Random& random) {
  const Vec3d back{random.uniform(0.1, 1), random.uniform(-0.7, 0.7), random.uniform(-1, 1)};
  const Vec3d target = random_point(random);
  return {target + random.uniform(0.1, 20) * back, target, random.uniform(15, 80)};
}

double distance(const Camera& camera) { return length(camera.eye - camera.target); }

}  // namespace

TEST_CASE("an eye that goes all the way round its target comes back") {
  Random random(1);
  for (int round = 0; round < 100; ++round) {
    const Camera first = random_camera(random);
    Camera camera = first;
    for (int step = 0; step < 12; ++step) camera = orbit(camera, kTurn / 12, step % 2 == 0 ? 0.1 : -0.1);
    CHECK(length(camera.eye - first.eye) < 1e-12 * distance(first) + 1e-14);
    CHECK(camera.target == first.target);
    CHECK(camera.fov_degrees == first.fov_degrees);
  }
}

TEST_CASE("an eye turns right and up by the angles asked for, at its distance") {
  const Camera front{{0, 1, 2}, {0, 1, 0}, 35};
  CHECK(length(orbit(front, kTurn / 4, 0).eye - Vec3d{2, 1, 0}) < 1e-15);
  CHECK(length(orbit(front, 0, kTurn / 8).eye - Vec3d{0, 1 + std::sqrt(2), std::sqrt(2)}) < 1e-15);
  Random random(2);
  for (int round = 0; round < 100; ++round) {
    const Camera before = random_camera(random);
    const Camera after = orbit(before, random.uniform(-9, 9), random.uniform(-9, 9));
    CHECK(distance(after) == doctest::Approx(distance(before)).epsilon(1e-14).scale(0));
  }
}

TEST_CASE("an eye stops before the poles, with its picture upright") {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    const Camera before = random_camera(random);
    const Basis level = basis_of(before);
    for (const double way : {1.0, -1.0}) {
      Camera camera = before;
      for (int step = 0; step < 40; ++step) camera = orbit(camera, 0, way * 0.1);
      const Basis basis = basis_of(camera);
      CHECK(std::asin(way * basis.back.y) == doctest::Approx(89 * kDegree));
      CHECK(length(basis.right - level.right) < 1e-12);  // neither turned nor turned over
      CHECK(basis.up.y > 0);
      camera = orbit(camera, 0, -way * kTurn / 4);
      CHECK(std::asin(way * basis_of(camera).back.y) == doctest::Approx(-1 * kDegree));
    }
  }
}

TEST_CASE("an eye at a pole or at its target can be turned") {
  const Camera above = orbit({{0, 5, 0}, {0, 0, 0}, 35}, 0, -kTurn / 8);
  CHECK(std::atan2(above.eye.y, above.eye.z) == doctest::Approx(kTurn / 8));
  const Camera inside = orbit({{1, 2, 3}, {1, 2, 3}, 35}, 1, 1);
  CHECK(inside.eye == Vec3d{1, 2, 3});
}

TEST_CASE("what lies at the target's depth moves with the pointer") {
  Random random(4);
  for (int round = 0; round < 200; ++round) {
    const Camera before = random_camera(random);
    const double aspect = random.uniform(0.3, 3);
    const double dx = random.uniform(-1, 1), dy = random.uniform(-1, 1);
    const Camera after = pan(before, dx, dy);
    const Projected target = project(after, aspect, before.target);
    CHECK(std::abs(target.x - 2 * dx / aspect) < 1e-12);  // a height is 2 / aspect of clip space across
    CHECK(std::abs(target.y - 2 * dy) < 1e-12);
    CHECK(target.depth == doctest::Approx(distance(before)).epsilon(1e-13).scale(0));
    CHECK(length((after.eye - after.target) - (before.eye - before.target)) < 1e-13 * distance(before));
  }
}

TEST_CASE("what lies beside the target gets as much larger as the zoom says") {
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    const Camera before = random_camera(random);
    const double factor = std::exp(random.uniform(-2, 2));
    const Camera after = zoom(before, factor);
    const Vec3d beside = before.target + 0.1 * basis_of(before).right;
    CHECK(project(after, 1, beside).x == doctest::Approx(factor * project(before, 1, beside).x));
    CHECK(after.target == before.target);
    CHECK(length(zoom(after, 1 / factor).eye - before.eye) < 1e-13 * distance(before));
  }
}
