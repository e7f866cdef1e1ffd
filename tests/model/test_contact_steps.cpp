// How often a frame is cut where something moves fast: bounds of speeds against what motions do.
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/contact_steps.hpp"
#include "scene/load.hpp"
#include "scene/motion.hpp"

using namespace weft;

namespace {

/// The largest speed between samples of a motion [m/s].
double sampled_speed(const scene::MotionShape& motion, const Vec3d& point, double begin, double end) {
  constexpr int kSamples = 400;
  double most = 0;
  const double step = (end - begin) / kSamples;
  for (int k = 0; k < kSamples; ++k)
    most = std::max(most, length(scene::motion_at(motion, begin + (k + 1) * step)(point) -
                                 scene::motion_at(motion, begin + k * step)(point)) /
                              step);
  return most;
}

}  // namespace

TEST_CASE("the bound of a motion's speed is no less than its samples, and no more than a little above") {
  Random random(51);
  for (int i = 0; i < 600; ++i) {
    const double ramp = i % 3 == 0 ? 0 : random.uniform(0.05, 1), speed = random.uniform(0.1, 3);
    const std::optional<double> end = i % 2 == 0 ? std::nullopt : std::optional(random.uniform(0.1, 3));
    const double start = random.uniform(0, 1), begin = random.uniform(0, 4),
                 width = random.uniform(0.01, 0.5);
    scene::MotionShape shape = scene::MotionLine{{0, 1, 0}, speed, end, start, ramp};
    Vec3d point{0, 0, 0};
    double lever = 0;
    if (i % 4 > 1) {
      shape = scene::MotionRotation{{0, 1, 0}, {1, 0, 0}, speed, end, start, ramp};
      point = {1, 5, 2};
      lever = 2;
    }
    const double bound = largest_speed({shape, lever, {}}, begin, begin + width);
    const double sampled = sampled_speed(shape, point, begin, begin + width);
    CHECK(bound >= sampled * (1 - 1e-6) - 1e-9);
    // A sample averages over 1/400 of the interval, where a chord or the end of the motion may fall.
    if (ramp > 0) CHECK(bound <= sampled + 2 * speed / ramp * width / 100 + 1e-3 * bound);
  }
  scene::MotionPath path{{{1, {0, 0, 0}}, {2, {0, 3, 0}}, {4, {0, 3, 1}}}};
  const auto speed_of = [&](double from, double to) { return largest_speed({path, 0, {}}, from, to); };
  CHECK(speed_of(0.2, 0.8) == 0);
  CHECK(speed_of(0.5, 1.5) == 3);
  CHECK(speed_of(2.5, 9) == 0.5);
  CHECK(speed_of(5, 9) == 0);
}

TEST_CASE("a frame is cut into the fewest substeps in which nothing moved travels farther than it may") {
  ContactMover mover{.motion = scene::MotionLine{{1, 0, 0}, 4, std::nullopt, 0, 0}};
  const auto factor = [&](double thickness, double step) {
    return contact_step_factor({&mover, 1}, 0, 1 / 60.0, thickness, step);
  };
  // 4 m/s over 1/60 s in 10 substeps: 6.67 mm each; half of 5 mm is 2.5 mm.
  const double speed = largest_speed(std::span(&mover, 1), 0, 1 / 60.0);
  CHECK(factor(0.005, 1 / 600.0) == 3);
  CHECK(factor(0.005, 1 / 1620.0) == 1);
  CHECK(factor(0.005, 1 / 1560.0) == 2);
  CHECK(factor(2 * 4 / 600.0, 1 / 600.0) == 1);  // just half
  CHECK(factor(1e-12, 1 / 60.0) == kMostContactSteps);
  CHECK(largest_speed(std::span(&mover, 1), 0, 1e9) == speed);  // however long it is looked at
  CHECK(largest_speed(std::span<const ContactMover>(), 0, 1 / 60.0) == 0);
  CHECK(contact_step_factor({}, 0, 1 / 60.0, 0.005, 1 / 60.0) == 1);
  mover.travel = 2;
  CHECK(factor(0.005, 1 / 600.0) == 1);
  CHECK(factor(0.005, 1 / 60.0) == 7);  // 66.7 mm, by no more than 10
}

TEST_CASE("what a scene moves: nodes, colliders about an axis as far as they reach, and meshes that deform") {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "contact": {"method": "proximity"},
    "cloths": [{"grid": [3, 3], "size": [2, 2], "density": 1,
      "motions": [{"nodes": "top", "kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 3}]}],
    "colliders": [{"kind": "sphere", "center": [3, 0, 0], "radius": 1},
      {"kind": "sphere", "center": [3, 9, 0], "radius": 1,
       "motion": {"kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 2}},
      {"kind": "mesh", "mesh": "a.ply", "keyframes": [{"time": 0.5, "mesh": "b.ply"},
      {"time": 1, "mesh": "c.ply"}]}]})",
                                        "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  const auto model = build_model(*scene, {{}});
  REQUIRE(model);
  mesh::TriangleMesh a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, b = a, c = a;
  b.positions[2] = {0, 3, 0};
  c.positions[2] = {0, 4, 0};
  mesh::Deformation deformation{{{0.5, 1}}, {b.positions, c.positions}};
  const std::vector<ContactMover> movers = contact_movers(*scene, *model, {&a, 1}, {&deformation, 1}, true);
  CHECK(movers[0].travel == 0.5);  // of cloth
  CHECK(movers[1].travel == 2);
  CHECK(contact_movers(*scene, *model, {&a, 1}, {&deformation, 1})[1].travel == 0.5);
  REQUIRE(movers.size() == 3);
  CHECK(largest_speed(movers[0], 0, 1) == doctest::Approx(3 * 1));  // the top's ends are 1 m from the axis
  const double reach = largest_speed(movers[1], 0, 1);
  CHECK(reach >= 2 * 4);
  CHECK(reach <= 2 * std::sqrt(17.0) + 1e-12);  // of its box
  CHECK(largest_speed(movers[2], 0.1, 0.2) == 4);
  CHECK(largest_speed(movers[2], 0.6, 0.9) == 2);
  CHECK(largest_speed(movers[2], 1.1, 2) == 0);
  deformation.times.loops = true;
  deformation.shapes[1] = a.positions;  // from 3 back to 1
  const ContactMover looping = contact_movers(*scene, *model, {&a, 1}, {&deformation, 1}).back();
  CHECK(largest_speed(looping, 0.1, 0.2) == 4);
  deformation.shapes[0][2] = {0, 2, 0};
  deformation.times.times = {0.5, 1.5};
  const ContactMover uneven = contact_movers(*scene, *model, {&a, 1}, {&deformation, 1}).back();
  CHECK(largest_speed(uneven, 0.6, 1.4) == 1);
  CHECK(largest_speed(uneven, 3.6, 4.4) == 1);
  CHECK(largest_speed(uneven, 3.1, 3.2) == 2);
  CHECK(largest_speed(uneven, 4.4, 4.6) == 2);  // into the next round
}

TEST_CASE("cloth keeps from cloth no more than half the median altitude of its triangles") {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1",
    "cloths": [{"grid": [11, 6], "size": [1, 1], "density": 1}]})",
                                        "test.json");
  REQUIRE(scene);
  const auto model = build_model(*scene, {{}});
  REQUIRE(model);
  const double altitude = 0.1 * 0.2 / std::sqrt(0.1 * 0.1 + 0.2 * 0.2);
  CHECK(typical_altitude(*model) == doctest::Approx(altitude));
  CHECK(self_thickness(*model, 0.005) == 0.005);
  CHECK(self_thickness(*model, 0.1) == doctest::Approx(altitude / 2));
}
