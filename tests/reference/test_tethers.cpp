// Tethers of cloth by projected constraints, in double: when they act, what they take, and how far cloth then hangs.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "method/perturb.hpp"
#include "method/stepper.hpp"
#include "rig.hpp"

using namespace weft;

namespace {

/// A grid of springs or fabric by a method that sweeps, as it stands at rest.
class Hung {
 public:
  Hung(const std::string& method, int sweeps, const std::string& cloth, const std::string& world = "") {
    auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "contact": {"method": "none"}, )" + world +
                                        R"("solver": {"kind": ")" + method + R"(", "iterations": )" +
                                        std::to_string(sweeps) + R"(}, "cloths": [{)" + cloth + "}]}",
                                    "test.json");
    REQUIRE_OK(scene);
    scene_ = std::move(*scene);
    auto model = build_model(scene_, {{}});
    REQUIRE_OK(model);
    model_ = std::make_unique<Model>(std::move(*model));
    system = reference::elements_of(*model_);
    system.position = model_->start_position;
    system.velocity.resize(model_->vertex_count());
    system.acceleration = scene_.gravity;
    system.drag = scene_.drag;
  }

  void advance(double dt, int steps) {
    const auto stepper = reference::make_stepper(scene_.solver, *model_, dt);
    const std::vector<Vec3d> places = system.position;  // held nodes stay
    for (int step = 0; step < steps; ++step) stepper->advance({system, places, dt});
  }
  /// Held nodes go by these ways in all [m], evenly.
  void carry(double dt, int steps, const std::vector<Vec3d>& ways) {
    const auto stepper = reference::make_stepper(scene_.solver, *model_, dt);
    const std::vector<Vec3d> from = system.position;
    for (int step = 1; step <= steps; ++step) {
      std::vector<Vec3d> places = from;
      for (std::size_t k = 0; k < places.size(); ++k) places[k] += (1.0 * step / steps) * ways[k];
      stepper->advance({system, places, dt});
    }
  }
  double longest_spring() const {  // by its length at rest
    double most = 0;
    for (const SpringLink& s : system.springs)
      most =
          std::max(most, length(system.position[s.node_a] - system.position[s.node_b]) / s.law().rest_length);
    return most;
  }
  double kinetic() const { return reference::energies(system).kinetic; }

  reference::MassSpringSystem system;

 private:
  scene::Scene scene_;
  std::unique_ptr<Model> model_;
};

std::string tethers(const std::string& slack) { return R"(, "tethers": {"slack": )" + slack + "}"; }

const std::string kFree = R"("gravity": [0, 0, 0], )";
const std::string kLimp =
    R"("stiffness": {"structural": 0, "shear": 0, "bend": 0}, "damping": 0, "density": 0.2)";

/// How far the lowest row of a sheet that hangs by its upper edge is below it, in the middle, by the length at rest.
double hung_length(const std::string& method, int sweeps, double dt, const std::string& more) {
  Hung sheet(method, sweeps,
             R"("grid": [9, 33], "size": [0.25, 1.0], "pins": ["top"], "density": 0.2, "damping": 0.05,
                "stiffness": {"structural": 500, "shear": 100, "bend": 5})" +
                 more,
             R"("drag": 2, )");
  const double top = sheet.system.position[4].y;
  sheet.advance(dt, static_cast<int>(3 / dt));
  return top - sheet.system.position[9 * 32 + 4].y;
}

}  // namespace

TEST_CASE(
    "tethers leave cloth alone that is nowhere longer than at rest: rigid, rolled, folded or crumpled") {
  for (const std::string method : {"xpbd", "pbd"})
    for (int shape = 0; shape < 4; ++shape) {
      CAPTURE(method);
      CAPTURE(shape);
      std::vector<std::vector<Vec3d>> ends;
      for (const std::string& more : {std::string(), tethers("0")}) {
        Hung sheet(method, 2, R"("grid": [11, 9], "size": [0.5, 0.4], "pins": ["top_left"], )" + kLimp + more,
                   kFree);
        const std::vector<Vec3d> rest = sheet.system.position;
        for (std::size_t v = 0; v < rest.size(); ++v) {
          if (sheet.system.inverse_mass[v] == 0) continue;
          Vec3d& x = sheet.system.position[v];
          const double down = rest[0].y - rest[v].y;
          if (shape == 1) x = {rest[v].x, rest[0].y - std::sin(5 * down) / 5, (1 - std::cos(5 * down)) / 5};
          if (shape == 2) x = {rest[v].x, rest[0].y - std::min(down, 0.2) + std::max(0.0, down - 0.2), 0};
          if (shape == 3) x = rest[0] + 0.8 * (rest[v] - rest[0]);
        }
        if (shape == 3) perturb(sheet.system, 3, 0.002, 0.1);
        sheet.advance(2e-3, 5);
        ends.push_back(sheet.system.position);
      }
      CHECK(ends[0] == ends[1]);  // to the bit
    }
}

TEST_CASE(
    "no way gets longer by a tether, so limp cloth never gains energy, and no node ends beyond its own") {
  for (const std::string method : {"xpbd", "pbd"})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const std::string shape =
          R"("grid": [7, 8], "size": [0.3, 0.35], "pins": ["top_left", "bottom_right"], )";
      Hung with(method, 3, shape + kLimp + tethers("0.1"), kFree), without(method, 3, shape + kLimp, kFree);
      perturb(with.system, seed, 1e-4, 4.0);
      without.system = with.system;
      for (int step = 0; step < 10; ++step) {
        const std::vector<Vec3d> before = with.system.position;
        const double energy = with.kinetic();
        with.advance(5e-3, 1);
        CHECK(with.kinetic() <= energy * (1 + 1e-12));
      }
      without.advance(5e-3, 10);
      CHECK(with.kinetic() < 0.9 * without.kinetic());  // they have acted
    }
}

TEST_CASE(
    "a tethered sheet that swings down from level has no more energy than it began with, nor than alone") {
  // Few long sweeps leave springs stretched, alone far more than with tethers; the motion itself never gains.
  for (const std::string method : {"xpbd", "pbd"})
    for (const double step : {2e-3, 8e-3})
      for (const int sweeps : {1, 4}) {
        CAPTURE(method);
        CAPTURE(step);
        CAPTURE(sweeps);
        const auto energies_of = [&](const std::string& more) {
          Hung sheet(method, sweeps,
                     R"("grid": [9, 17], "size": [0.25, 0.5], "plane": "xz", "pins": ["top"],
              "density": 0.2, "damping": 0.02, "stiffness": {"structural": 500, "shear": 100, "bend": 5})" +
                         more);
          const reference::EnergySums first = reference::energies(sheet.system);
          double motion = -HUGE_VAL, springs = 0, lowest = 0;
          for (int k = 0; k < static_cast<int>(1.0 / step); ++k) {
            sheet.advance(step, 1);
            const reference::EnergySums now = reference::energies(sheet.system);
            motion = std::max(motion, now.kinetic + now.potential - first.total());
            springs = std::max(springs, now.springs);
            lowest = std::min(lowest, now.potential - first.potential);
          }
          return std::array{motion, springs, lowest};
        };
        const auto [motion, springs, lowest] = energies_of(tethers("0.01"));
        const double alone = energies_of("")[1];
        MESSAGE(method << ", " << step << " s, " << sweeps << " sweeps: motion by " << motion
                       << " J, springs " << springs << ", alone " << alone);
        CHECK(motion <= 1e-12);
        CHECK(springs <= alone);
        CHECK(lowest < -0.05);  // it swung: 25 g fall by a quarter of a metre
      }
}

TEST_CASE("spin about a held node is kept by its tether, as the step shrinks, to first order") {
  std::vector<double> lost;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    Hung ball("xpbd", 1, R"("grid": [2, 2], "size": [0.3, 0.3], "pins": ["top"], )" + kLimp + tethers("0"),
              kFree);
    const Vec3d pin = ball.system.position[0];
    ball.system.velocity[2] = {0, 0, 2};  // it hangs below that pin; the other one, aside, does not bind it
    const auto spin = [&] { return length(cross(ball.system.position[2] - pin, ball.system.velocity[2])); };
    const double first = spin();
    ball.advance(step, static_cast<int>(std::lround(0.4 / step)));
    lost.push_back(1 - spin() / first);
    CHECK(length(ball.system.position[2] - pin) == doctest::Approx(0.3).epsilon(1e-5).scale(0));
  }
  MESSAGE("spin lost: " << lost[0] << ", " << lost[1] << ", " << lost[2]);
  // A step by the angle a begins along a chord, and ends beyond the tether by a part a² of it: v² h / L² a second.
  const double expected = 2.0 * 2.0 * 1e-3 / (0.3 * 0.3) * 0.4;
  CHECK(lost[2] == doctest::Approx(expected).epsilon(0.05).scale(0));
  CHECK(lost[0] / lost[1] == doctest::Approx(2).epsilon(0.05).scale(0));
  CHECK(lost[1] / lost[2] == doctest::Approx(2).epsilon(0.05).scale(0));
}

TEST_CASE("a sheet that hangs by few sweeps is as long with tethers as by many without") {
  const double converged = hung_length("xpbd", 30, 2e-3, "");
  for (const std::string method : {"xpbd", "pbd"})
    for (const int sweeps : {1, 4}) {
      const double alone = hung_length(method, sweeps, 1.0 / 120, ""),
                   tethered = hung_length(method, sweeps, 1.0 / 120, tethers("0.01"));
      MESSAGE(method << ", " << sweeps << " sweeps of 1/120 s: " << alone << " m alone, " << tethered
                     << " with tethers; converged " << converged);
      CHECK(alone > converged + 0.03);                // what (7) of docs/solvers/xpbd.md leaves
      CHECK(tethered <= 1.01 * (1 + 2e-6));           // the tethers' own bound
      CHECK(std::abs(tethered - converged) <= 0.01);  // whose slack is as much as the springs give way
    }
}

TEST_CASE(
    "clips that are drawn farther apart than a sheet is wide stretch it no more with tethers than without") {
  for (const std::string method : {"xpbd", "pbd"}) {
    const auto drawn = [&](const std::string& more) {
      Hung sheet(method, 8,
                 R"("grid": [13, 13], "size": [0.6, 0.6], "pins": ["top_left", "top_right"], "density": 0.2,
              "damping": 0.01, "stiffness": {"structural": 500, "shear": 100, "bend": 5})" +
                     more,
                 kFree);
      std::vector<Vec3d> ways(sheet.system.position.size());
      ways[12] = {0.18, 0, 0};  // the upper right corner: to 1.3 of the width
      double most = 0;
      for (int part = 0; part < 30; ++part) {
        std::vector<Vec3d> a_part = ways;
        for (Vec3d& way : a_part) way = (1.0 / 30) * way;
        sheet.carry(2e-3, 4, a_part);
        most = std::max(most, sheet.longest_spring());
      }
      return std::pair(most, sheet.kinetic());
    };
    const auto [alone, slow] = drawn("");
    const auto [tethered, fast] = drawn(tethers("0"));
    MESSAGE(method << ": longest spring " << alone << " alone, " << tethered << " with tethers; " << slow
                   << " and " << fast << " J of motion");
    CHECK(alone > 1.3);
    CHECK(tethered > 1.29);
    CHECK(tethered < alone);
  }
}
