#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "scene/load.hpp"
#include "scene/motion.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

Motion motion(const std::string& members) {
  auto scene = parse_scene(motion_with(members), "a.json");
  if (!scene) FAIL(scene.error().message);
  return scene->cloths[0].motions[0];
}

bool close(const Vec3d& a, const Vec3d& b, double tolerance = 1e-13) { return length(a - b) <= tolerance; }

}  // namespace

TEST_CASE("a line without a ramp is speed times time between its start and its end") {
  const Motion line =
      motion(R"("kind": "line", "direction": [0, 3, 4], "speed": 2, "distance": 5, "start": 1)");
  const Vec3d p{7, 8, 9}, d{0, 0.6, 0.8};
  CHECK(motion_at(line, -1)(p) == p);
  CHECK(motion_at(line, 1)(p) == p);
  CHECK(close(motion_at(line, 2)(p), p + d * 2.0));
  CHECK(close(motion_at(line, 3.5)(p), p + d * 5.0));
  CHECK(close(motion_at(line, 1e6)(p), p + d * 5.0));
  const Motion endless = motion(R"("kind": "line", "direction": [1, 0, 0], "speed": 2)");
  CHECK(motion_at(endless, 1000)({}) == Vec3d{2000, 0, 0});
}

TEST_CASE("a ramp rises as a t^2 / 2, loses half its time, and ends at the distance at rest") {
  const auto at = [](double t) {
    return travelled(t, 2, 0.5, 5.0);
  };  // a = 4 m/s²; ends at 5 / 2 + 0.5 = 3 s
  CHECK(at(0) == 0);
  CHECK(at(0.25) == doctest::Approx(0.5 * 4 * 0.25 * 0.25));
  CHECK(at(0.5) == doctest::Approx(0.5));
  CHECK(at(1.5) == doctest::Approx(2 * (1.5 - 0.25)));
  CHECK(at(2.5) == doctest::Approx(4.5));
  CHECK(at(2.75) == doctest::Approx(5 - 0.5 * 4 * 0.25 * 0.25));
  CHECK(at(3) == 5);
  CHECK(at(100) == 5);
}

TEST_CASE("a distance too short for the full speed cuts both ramps at the same slope") {
  const auto at = [](double t) {
    return travelled(t, 10, 2, 5.0);
  };  // a = 5 m/s²; peak 5 m/s after 1 s, end after 2 s
  CHECK(at(0.5) == doctest::Approx(0.625));
  CHECK(at(1) == doctest::Approx(2.5));
  CHECK(at(1.5) == doctest::Approx(5 - 0.625));
  CHECK(at(2) == doctest::Approx(5));
  CHECK(at(2.001) == 5);
}

TEST_CASE("motions are continuous, never go back, and keep to their speed and slope, for random parameters") {
  for (int k = 0; k < 300; ++k) {
    const double speed = 0.1 + 0.037 * k, ramp = k % 5 == 0 ? 0 : 0.01 * k,
                 distance = 0.2 + 0.11 * ((k * 7) % 50);
    const std::optional<double> end = k % 3 == 0 ? std::nullopt : std::optional(distance);
    const double step = 1e-3;
    double before = 0, speed_before = 0;
    for (int n = 1; n <= 4000; ++n) {
      const double now = travelled(n * step, speed, ramp, end);
      const double speed_now = (now - before) / step;
      const bool fine =
          speed_now >= -1e-9 && speed_now <= speed * (1 + 1e-9) && (!end || now <= *end * (1 + 1e-12)) &&
          (ramp == 0 || std::abs(speed_now - speed_before) <= speed / ramp * step * (1 + 1e-6) + 1e-9);
      if (!fine) FAIL("k " << k << ", step " << n << ": speed " << speed_before << " then " << speed_now);
      before = now;
      speed_before = speed_now;
    }
  }
}

TEST_CASE("a motion that ends comes to its end exactly") {
  for (int k = 1; k < 2000; ++k) {
    const double speed = 0.013 * k, ramp = 0.0007 * ((k * 31) % 500), end = 0.0031 * ((k * 17) % 700 + 1);
    CHECK(travelled(end / speed + 2 * ramp + 1e4, speed, ramp, end) == end);
  }
}

TEST_CASE("a path goes straight between its points, from rest at time 0, and stays at its last") {
  const Motion path = motion(R"("kind": "path", "points": [[1, [1, 0, 0]], [3, [1, 4, 0]]])");
  CHECK(motion_at(path, -1)({}) == Vec3d{});
  CHECK(motion_at(path, 0)({}) == Vec3d{});
  CHECK(close(motion_at(path, 0.5)({}), {0.5, 0, 0}));
  CHECK(close(motion_at(path, 1)({}), {1, 0, 0}));
  CHECK(close(motion_at(path, 1.5)({0, 0, 1}), {1, 1, 1}));
  CHECK(close(motion_at(path, 3)({}), {1, 4, 0}));
  CHECK(close(motion_at(path, 99)({}), {1, 4, 0}));
  const Motion given = motion(R"("kind": "path", "points": [[0, [0, 0, 2]], [1, [0, 0, 3]]])");
  CHECK(motion_at(given, 0)({}) == Vec3d{0, 0, 2});
  CHECK(close(motion_at(given, 0.5)({}), {0, 0, 2.5}));
}

TEST_CASE("a rotation turns right-handed about its centre and ends at its angle") {
  const std::string members = R"("kind": "rotation", "axis": [0, 0, 2], "center": [1, 0, 5], "speed": 0.5)";
  const double pi = std::acos(-1.0);
  const Motion turn = motion(members);
  CHECK(close(motion_at(turn, pi)({2, 0, 7}), {1, 1, 7}));  // a quarter turn
  CHECK(close(motion_at(turn, 4 * pi)({2, 0, 7}), {2, 0, 7}));
  CHECK(motion_at(turn, 0)({2, 0, 7}) == Vec3d{2, 0, 7});
  const Motion half = motion(members + ", \"angle\": 3.141592653589793, \"ramp\": 0.25, \"start\": 1");
  CHECK(close(motion_at(half, 1e5)({2, 0, 7}), {0, 0, 7}));
  const Motion tilted = motion(R"("kind": "rotation", "axis": [1, 1, 1], "center": [0, 0, 0], "speed": 1)");
  CHECK(close(motion_at(tilted, 2 * pi / 3)({1, 2, 3}), {3, 1, 2}));  // x -> y -> z -> x
}

TEST_CASE("a collider moves as nodes with the same motion do") {
  for (const char* members :
       {R"("kind": "line", "direction": [0, 3, 4], "speed": 2, "distance": 5, "start": 1, "ramp": 0.25)",
        R"("kind": "path", "points": [[0, [0, 0, 2]], [1, [0, 0, 3]]])",
        R"("kind": "rotation", "axis": [3, -2, 7], "center": [1, 2, 3], "speed": 2)"}) {
    const auto scene =
        parse_scene(proximity_with(R"({"kind": "sphere", "center": [7, 8, 9], "radius": 1, "motion": {)" +
                                   std::string(members) + "}}"),
                    "a.json");
    REQUIRE(scene);
    const ColliderMotion& moved = *motion_of(scene->colliders[0]);
    for (const double time : {0.0, 0.3, 1.2, 99.0})
      CHECK(motion_at(moved, time)({7, 8, 9}) == motion_at(motion(members), time)({7, 8, 9}));
  }
}

TEST_CASE("a rotation keeps distances for all angles") {
  const Motion turn =
      motion(R"("kind": "rotation", "axis": [3, -2, 7], "center": [1, 2, 3], "speed": 10000)");
  for (int k = 0; k < 1000; ++k) {
    const RigidTransform place = motion_at(turn, k * k * 0.977);
    CHECK(length(place({5, 6, 7}) - place({-1, 0, 2})) ==
          doctest::Approx(length(Vec3d{6, 6, 5})).epsilon(1e-14).scale(0));
    CHECK(close(place({1, 2, 3}), {1, 2, 3}));
  }
}
