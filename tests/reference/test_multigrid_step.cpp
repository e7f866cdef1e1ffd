// The multigrid solver's substep in double: order, energy, momentum, agreement with explicit steps, survival.
#include <complex>

#include "relative_error.hpp"
#include "rig.hpp"
#include "sheets.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

bool all_finite(const std::vector<Vec3d>& values, double bound) {
  for (const Vec3d& v : values)
    if (!(length(v) < bound)) return false;
  return true;
}

/// A stretched membrane, pinned all around, that swings: smooth, and no spring is ever pressed.
Sheet slack_sheet() {
  Sheet sheet(
      R"("cloths": [{"grid": [13, 10], "size": [1, 0.75], "plane": "xz", "density": 0.2, "damping": 0.05,
      "stiffness": {"structural": 300, "shear": 100, "bend": 20, "bending": 1e-4}, "pins": ["edges"]}])");
  for (std::size_t node = 0; node < sheet.system.position.size(); ++node) {
    Vec3d& x = sheet.system.position[node];
    const double out = std::cos(3.14159265 * x.x) * std::cos(3.14159265 * x.z / 0.75);
    x = {1.1 * x.x, sheet.system.inverse_mass[node] > 0 ? 0.05 * out : 0, 1.1 * x.z};
  }
  sheet.system.drag = 0.3;
  return sheet;
}

std::vector<Vec3d> swung(int steps, double residual) {
  Sheet sheet = slack_sheet();
  sheet.stepper.wanted_residual = residual;
  sheet.advance(0.05 / steps, steps);
  return sheet.system.position;
}

}  // namespace

TEST_CASE(
    "the step is of second order in time with solved systems, and errs no more as they are solved by "
    "default") {
  const Sheet start = slack_sheet();
  const std::vector<Vec3d> exact = swung(4096, 1e-10);
  double before = 0;
  for (const int steps : {32, 64, 128, 256, 512}) {
    const auto error = [&](double residual) {
      return relative_error(swung(steps, residual), exact, start.system.position);
    };
    const double solved = error(1e-10), usual = error(scene::Solver{}.residual);
    MESSAGE(steps << " steps: error " << solved << ", order " << std::log2(before / solved) << "; by default "
                  << usual / solved << " of that");
    if (steps > 64) CHECK(std::log2(before / solved) > 1.8);
    CHECK(usual < 1.1 * solved);
    before = solved;
  }
  CHECK(before < 0.001);
}

TEST_CASE("a sheet falls as with explicit steps, within 1.5 % at 64 x 64 after a quarter and half a second") {
  std::vector<scene::Override> grid = {{"cloths.0.grid", "[64,64]"}};
  auto implicit = simulation_of_file("sheet", grid);
  CHECK(implicit.substeps() == 8);
  grid.push_back({"solver.kind", "mass_spring"});
  auto exact = simulation_of_file("sheet", grid);
  const std::vector<Vec3d> start = exact.positions();
  for (const double time : {0.25, 0.5}) {
    while (implicit.time() < time - 1e-9) {
      advance(implicit, 1);
      advance(exact, 1);
    }
    const double error = relative_error(implicit.positions(), exact.positions(), start);
    MESSAGE("at " << time << " s: " << 100 * error << " % with " << implicit.substeps()
                  << " substeps against " << exact.substeps());
    CHECK(error < 0.015);
  }
}

TEST_CASE("a pendulum loses the energy that BDF2 takes from its frequency") {
  // A strip of 2 x 2 nodes, the upper two pinned, swings at sqrt(g / l) for small angles. Springs are soft
  // enough that what a step across them stretches, l (w h angle)² / 2, holds no energy to speak of.
  Sheet sheet(R"("cloths": [{"grid": [2, 2], "size": [1, 1], "node_mass": 1, "damping": 0,
                 "stiffness": {"structural": 1e4, "shear": 1e4, "bend": 0}, "pins": ["top"]}])");
  sheet.stepper.wanted_residual = 1e-12;
  const double angle = 0.01, dt = 0.1;
  for (std::size_t node = 2; node < 4; ++node) {
    sheet.system.position[node].y = 0.5 - std::cos(angle);
    sheet.system.position[node].z = std::sin(angle);
  }
  // y'' = -w² y by BDF2: (3 x - 4 x' + x'') / 2h = v and the same for v. The damping of its principal root
  // follows from the polynomial (z - 4/3 + 1/(3z)) ± i (2/3) w h z = 0.
  const double w = std::sqrt(9.81), wh = w * dt;
  const std::complex<double> lead(1, -2.0 / 3 * wh);
  const std::complex<double> root = (4.0 / 3 + std::sqrt(16.0 / 9 - 4.0 / 3 * lead)) / (2.0 * lead);
  const auto energy = [&] {
    const Vec3d x = sheet.system.position[2], v = sheet.system.velocity[2];
    return 0.5 * v.z * v.z + 0.5 * w * w * x.z * x.z;
  };
  sheet.advance(dt, 4);  // the first step is backward Euler
  const double first = energy();
  const int steps = 120;
  sheet.advance(dt, steps);
  const double expected = std::pow(std::abs(root), 2 * steps), kept = energy() / first;
  MESSAGE("kept " << kept << " of the energy in " << steps << " steps of w h = " << wh << ", expected "
                  << expected);
  CHECK(expected < 0.7);
  CHECK(kept == doctest::Approx(expected).epsilon(0.1).scale(0));
}

TEST_CASE("a free sheet keeps its momentum, and falls as a stone") {
  Sheet sheet(
      R"("cloths": [{"grid": [19, 14], "size": [2, 1.5], "plane": "xz", "density": 0.2, "damping": 0.25,
                 "stiffness": {"structural": 5000, "shear": 2000, "bend": 500, "bending": 1e-3}}])");
  sheet.perturb(3, 0.01, 1);
  sheet.stepper.wanted_residual = 1e-12;
  double mass = 0;
  const auto momentum = [&] {
    Vec3d sum;
    mass = 0;
    for (std::size_t n = 0; n < sheet.system.velocity.size(); ++n) {
      sum += sheet.mass(n) * sheet.system.velocity[n];
      mass += sheet.mass(n);
    }
    return sum;
  };
  const Vec3d before = momentum();
  sheet.advance(1.0 / 480, 24);
  const Vec3d change = momentum() - before;
  CHECK(length(change - Vec3d{0, -9.81 * 24 / 480 * mass, 0}) < 1e-9 * mass);
  // What is left of the residual would act as a force on the whole: docs/momentum.md.
  sheet.stepper.wanted_residual = scene::Solver{}.residual;
  const Vec3d between = momentum();
  sheet.advance(1.0 / 480, 24);
  const double drift =
      length(momentum() - between - Vec3d{0, -9.81 * 24 / 480 * mass, 0}) / (9.81 * 24 / 480 * mass);
  MESSAGE("as solved by default momentum drifts by " << drift << " of the weight");
  CHECK(drift < 1e-11);
}

TEST_CASE("a free sheet in even wind of 100 m/s is carried along, and not stretched") {
  Sheet sheet(
      R"("cloths": [{"grid": [33, 25], "size": [2, 1.5], "plane": "xz", "density": 0.2, "damping": 0.01,
                 "stiffness": {"structural": 5000, "shear": 2000, "bend": 500}}])");
  sheet.system.drag = 2;
  sheet.system.acceleration = {};
  sheet.system.wind.velocity = {100, 20, 30};
  double stretch = 1;
  for (int step = 0; step < 480; ++step) {
    sheet.advance(1.0 / 480, 1);
    for (const SpringLink& s : sheet.system.springs) {
      const double now = length(sheet.system.position[s.node_a] - sheet.system.position[s.node_b]);
      stretch = std::max(stretch, std::max(now / s.rest_length, s.rest_length / now));
    }
  }
  const double carried = 1 - std::exp(-2.0);  // v' = -2 (v - w)
  MESSAGE("an edge is off by at most ", stretch - 1, ", and ", sheet.system.velocity[0].x, " m/s of ",
          100 * carried);
  CHECK(stretch < 1.001);
  CHECK(sheet.system.velocity[0].x == doctest::Approx(100 * carried).epsilon(1e-3).scale(0));
}

TEST_CASE("a step of another length goes on by BDF2, and the first is backward Euler") {
  const StepFormula even = step_formula(0.01, 1), first = step_formula(0.01, 0),
                    half = step_formula(0.01, 0.5);
  CHECK(even.he == doctest::Approx(0.02 / 3));
  CHECK(even.c == doctest::Approx(1.0 / 3));
  CHECK(first.he == 0.01);
  CHECK(first.c == 0);
  // x = t²: x(0) = 0, x' = 2 t. From -2h to 0 to h the formula is exact.
  CHECK(half.c * (0 - 4e-4) + half.he * 2 * 0.01 == doctest::Approx(1e-4));
}

TEST_CASE("sheets survive stiffness, lightness, soft shear and violent pins for 500 steps") {
  struct Case {
    const char* name;
    std::string stiffness, density, motion;
  };
  const std::string usual = R"("structural": 5000, "shear": 2000, "bend": 500)";
  const std::string jump =
      R"("motions": [{"nodes": "top", "kind": "path",
         "points": [[0.1, [0, 0, 0]], [0.1167, [1, 0, 0]], [0.5, [1, 0, 0]], [0.5167, [0, 0.5, -0.5]]]}])";
  const std::string pins = R"("pins": ["top_left", "top_right"])";
  for (const Case& c :
       {Case{"100 times the stiffness", R"("structural": 5e5, "shear": 2e5, "bend": 5e4)", "0.2", pins},
        {"0.01 of the density", usual, "0.002", pins},
        {"pins moved a metre in a frame", usual, "0.2", jump},
        {"shear 10 times softer", R"("structural": 5000, "shear": 500, "bend": 0, "bending": 1e-4)", "0.2",
         pins},
        {"0.01 of the density and pins moved", usual, "0.002", jump}}) {
    CAPTURE(c.name);
    auto simulation = simulation_of_text(
        R"("solver": {"kind": "multigrid"}, "contact": {"method": "none"},
           "cloths": [{"grid": [33, 25], "size": [2, 1.5], "density": )" +
        c.density + R"(, "damping": 0.01, "stiffness": {)" + c.stiffness + "}, " + c.motion + "}]");
    advance(simulation, 63);  // of 8 steps
    CHECK(all_finite(simulation.positions(), 5));
    CHECK(all_finite(simulation.velocities(), 50));
  }
}
