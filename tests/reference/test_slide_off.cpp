// Stiff cloth that slides on a curve: what its springs have to say must not hide what its weight does. In double.
#include <cmath>

#include "rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81, kThickness = 0.005;  // [m/s²], [m]

/// The angle from above of a point that slides off a ball from rest, without friction, while it stays on it [rad].
double slid(double begin, double radius, double time) {
  double angle = begin, rate = 0;
  constexpr int kSteps = 10000;
  for (int step = 0; step < kSteps; ++step) {
    rate += time / kSteps * kGravity / radius * std::sin(angle);
    angle += time / kSteps * rate;
  }
  return angle;
}

/// Of the middle of a patch of so many nodes a side, 10 mm apart, which begins on top under a gravity that is tilted.
double found(double begin, double radius, int nodes, int frames) {
  const auto text = [](double number) { return std::to_string(number); };
  const double size = 0.01 * (nodes - 1);
  auto simulation = simulation_of_text(
      R"("gravity": [)" + text(kGravity * std::sin(begin)) + ", " + text(-kGravity * std::cos(begin)) +
      R"(, 0], "solver": {"kind": "multigrid"}, "contact": {"thickness": )" + text(kThickness) +
      R"(, "self": false}, "cloths": [{"grid": [)" + std::to_string(nodes) + ", " + std::to_string(nodes) +
      R"(], "size": [)" + text(size) + ", " + text(size) + R"(], "plane": "xz", "density": 0.2, "friction": 0,
      "stiffness": {"structural": 1500, "shear": 500, "bend": 0}, "transform": {"translate": [0, )" +
      text(radius + kThickness) +
      R"(, 0]}}], "colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": )" + text(radius) + "}]");
  advance(simulation, frames);
  Vec3d middle;
  for (const Vec3d& x : simulation.positions()) middle += x;
  return begin + std::atan2(middle.x, middle.y);
}

}  // namespace

TEST_CASE("a patch slides off a ball without friction as a point does, however stiff it is, in double") {
  for (const auto& [radius, frames] : {std::pair{0.2, 14}, {0.3, 18}})
    for (const int nodes : {3, 5, 7}) {
      CAPTURE(radius);
      CAPTURE(nodes);
      const double begin = 0.3, law = slid(begin, radius + kThickness, frames / 60.0),
                   angle = found(begin, radius, nodes, frames);
      const double part = (angle - begin) / (law - begin);
      MESSAGE(part << " of a point's way");
      REQUIRE(std::cos(law) > 2.0 / 3 * std::cos(begin));  // it has not left the ball
      CHECK(part == doctest::Approx(1).epsilon(0.03).scale(0));
    }
}
