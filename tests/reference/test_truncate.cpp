// Displacements that are cut at planes, and obstacles at a time.
#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

#include "base/random.hpp"
#include "contact/reference/proximity/obstacles.hpp"
#include "contact/reference/proximity/truncate.hpp"
#include "mesh/primitives.hpp"
#include "scene/load.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

TEST_CASE("a displacement is cut where it meets the first plane, and at its reach") {
  const Vec3d up{0, 1, 0};
  const double free[] = {1};
  const auto cut = [&](std::vector<SidePlane> planes, Vec3d from, Vec3d to, double reach) {
    const Vec3d previous[] = {from};
    Vec3d position[] = {to};
    const std::uint32_t count = truncate(planes, previous, free, reach, position);
    CHECK(count == (position[0] == to ? 0 : 1));
    return position[0];
  };
  CHECK(cut({}, {0, 0, 0}, {3, 4, 0}, 6) == Vec3d{3, 4, 0});
  CHECK(cut({}, {0, 0, 0}, {3, 4, 0}, 2.5) == Vec3d{1.5, 2, 0});
  CHECK(cut({{0, up, 0}, {0, up, 0.5}}, {0, 1, 0}, {4, -1, 0}, 9) == Vec3d{1, 0.5, 0});
  CHECK(cut({{0, up, 0}}, {0, 1, 0}, {4, 0.25, 0}, 9) == Vec3d{4, 0.25, 0});
  // Already behind a plane of cloth: it may come back, not go on.
  CHECK(cut({{0, up, 2}}, {0, 1, 0}, {4, -1, 0}, 9) == Vec3d{0, 1, 0});
  CHECK(cut({{0, up, 2}}, {0, 1, 0}, {4, 1.5, 0}, 9) == Vec3d{4, 1.5, 0});
  // An obstacle that has come past it takes it along.
  CHECK(cut({{0, up, 2, true}}, {0, 1, 0}, {4, -1, 0}, 9) == Vec3d{4, 2, 0});
  const double kinematic[] = {0};
  const Vec3d previous[] = {{0, 1, 0}};
  Vec3d position[] = {{0, -1, 0}};
  const SidePlane plane{0, up, 0, true};
  CHECK(truncate({&plane, 1}, previous, kinematic, 0.1, position) == 0);
  CHECK(position[0] == Vec3d{0, -1, 0});
}

TEST_CASE("after the cut every vertex is on its side of every plane, from which it came") {
  Random random(61);
  for (int round = 0; round < 300; ++round) {
    std::vector<SidePlane> planes;
    const Vec3d previous[] = {{}};
    for (int p = 0; p < 8; ++p) {
      const Vec3d n = random_point(random, 1);
      planes.push_back({0, n / length(n), -random.uniform(0, 0.5), false});
    }
    const double free[] = {1};
    Vec3d position[] = {random_point(random, 1)};
    truncate(planes, previous, free, 10, position);
    for (const SidePlane& plane : planes) CHECK(dot(plane.normal, position[0]) >= plane.offset - 1e-15);
  }
}

TEST_CASE("obstacles are where motions and keyframes have taken them") {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "contact": {"method": "proximity"},
    "cloths": [{"grid": [2, 2], "size": [1, 1], "density": 1}],
    "colliders": [{"kind": "sphere", "center": [1, 0, 0], "radius": 0.5, "friction": 0.7},
      {"kind": "mesh", "mesh": "box", "keyframes": [{"time": 1, "mesh": "b"}, {"time": 3, "mesh": "c"}],
       "motion": {"kind": "line", "direction": [0, 0, 1], "speed": 2}},
      {"kind": "capsule", "a": [0, 0, 0], "b": [1, 0, 0], "radius": 0.1},
      {"kind": "plane", "point": [1, 0, 0], "normal": [1, 0, 0],
       "motion": {"kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 1}}]})",
                                        "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  const mesh::TriangleMesh box = mesh::make_box({2, 2, 2});
  mesh::TriangleMesh wide = box, high = box;
  for (Vec3f& p : wide.positions) p.x *= 3;
  for (Vec3f& p : high.positions) p.y += 8;
  const std::vector<mesh::TriangleMesh> keyframes[] = {{wide, high}};
  const Obstacles obstacles(*scene, {&box, 1}, keyframes);
  CHECK_FALSE(obstacles.still());
  CHECK(obstacles.features().vertices.size() == 8 + 1 + 2);
  CHECK(obstacles.features().edges.size() == 18 + 1);
  CHECK(obstacles.features().radius_of_vertex(3) == 0);
  CHECK(obstacles.features().radius_of_vertex(8) == 0.5);
  CHECK(obstacles.features().radius_of_edge(0) == 0);
  CHECK(obstacles.features().radius_of_edge(18) == 0.1);
  CHECK(obstacles.collider_of_vertex(0) == 1);
  CHECK(obstacles.collider_of_vertex(8) == 0);
  CHECK(obstacles.collider_of_vertex(10) == 2);
  CHECK(obstacles.friction(0) == 0.7);
  CHECK_FALSE(obstacles.friction(1));
  for (const auto& [time, stretch, lift] : {std::tuple{0.0, 1.0, 0.0},
                                            {0.5, 2.0, 0.0},
                                            {1.0, 3.0, 0.0},
                                            {2.5, 1.5, 6.0},
                                            {3.0, 1.0, 8.0},
                                            {9.0, 1.0, 8.0}}) {
    const Obstacles::Placed placed = obstacles.at(time);
    for (std::size_t v = 0; v < 8; ++v) {
      const Vec3d rest = box.positions[v].to<double>();
      CHECK(length(placed.positions[v] - Vec3d{stretch * rest.x, rest.y + lift, rest.z + 2 * time}) <
            1e-14 * (1 + time));
    }
    CHECK(placed.positions[8] == Vec3d{1, 0, 0});
    // Turned about y: x goes to (cos, 0, -sin).
    const Vec3d expected{std::cos(time), 0, -std::sin(time)};
    CHECK(length(placed.planes[0].normal - expected) < 1e-15);
    CHECK(length(placed.planes[0].point - expected) < 1e-15);
    const Vec3d point{0.3, -0.2, 0.9};
    CHECK(length(carried(placed.transforms[3](point), placed.transforms[3], obstacles.at(7).transforms[3]) -
                 obstacles.at(7).transforms[3](point)) < 1e-15);
  }
}
