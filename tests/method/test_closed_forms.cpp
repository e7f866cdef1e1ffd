// What can be said without a computer, the solver must say too.
#include <cmath>

#include "gpu/gpu_fixture.hpp"
#include "method/mass_spring/plan.hpp"
#include "method/mass_spring/spectrum.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // [m/s²]
constexpr double kPi = 3.14159265358979323846;

std::string grid(std::uint32_t nx, std::uint32_t ny, double width, double height, const std::string& more) {
  return R"("cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) + R"(], "size": [)" +
         std::to_string(width) + ", " + std::to_string(height) + "], " + more + "}]";
}

}  // namespace

TEST_CASE("free fall follows y = y0 - g h² n (n + 1) / 2, the sum of semi-implicit Euler") {
  GpuFixture fixture;
  const double h = 1.0 / 256;  // exact in f32
  SolverRig rig(
      fixture.device(),
      scene_of(
          grid(5, 4, 1, 1,
               R"("density": 0.2, "damping": 0, "stiffness": {"structural": 10, "shear": 5, "bend": 1})")),
      h);
  const auto start = rig.positions();
  const int steps = 100;
  rig.advance(steps);
  const auto end = rig.positions();
  const double fall = kGravity * h * h * steps * (steps + 1) / 2;
  for (std::size_t i = 0; i < end.size(); ++i) {
    // Each step rounds a position below 1 m and a velocity below 4 m/s.
    CHECK(std::abs(static_cast<double>(start[i].y) - fall - static_cast<double>(end[i].y)) <
          steps * (1.2e-7 + h * 4 * 1.2e-7) * 4);
    CHECK(std::abs(end[i].x - start[i].x) < 1e-6F);
  }
}

TEST_CASE("without springs a node takes on the wind as v_n = w (1 - (1 - c h)^n)") {
  GpuFixture fixture;
  const double h = 1.0 / 256, drag = 3;  // exact in f32
  const Vec3d wind{2, -0.5, 1};
  const std::string air = R"("gravity": [0, 0, 0], "drag": 3, "wind": {"velocity": [2, -0.5, 1]}, )";
  const std::string loose = R"("density": 0.2, "stiffness": {"structural": 0, "shear": 0, "bend": 0})";
  const std::string scatter = R"("solver": {"kind": "mass_spring", "forces": "spring_centric"}, )";
  SolverRig rigs[] = {{fixture.device(), scene_of(air + grid(3, 4, 1, 1, loose)), h},
                      {fixture.device(), scene_of(air + scatter + grid(3, 4, 1, 1, loose)), h},
                      {fixture.device(),
                       scene_of(air + R"("cloths": [{"mesh": "a.obj", )" + loose + "}]"),
                       h,
                       {sheet_mesh(3, 4, 1, 1)}}};
  for (SolverRig& rig : rigs) {
    int steps = 0;
    for (const int more : {1, 9, 90, 1900}) {
      rig.advance(static_cast<std::uint32_t>(more));
      steps += more;
      const Vec3d expected = wind * (1 - std::pow(1 - drag * h, steps));
      for (const Vec4f& v : rig.velocities())
        // Each step rounds three times at most 2 m/s; what is left of a rounding falls as (1 - c h)^n.
        CHECK(length(v.xyz().to<double>() - expected) < 3 * 1.2e-7 * std::min(steps, 86) * 2);
    }
  }
}

TEST_CASE("a grabbed node goes to its target as (1 - r h)^n") {
  GpuFixture fixture;
  const double h = 1.0 / 512, rate = 20;
  SolverRig rig(fixture.device(),
                scene_of(grid(4, 4, 1, 1,
                              R"("density": 0.2, "stiffness": {"structural": 50, "shear": 20, "bend": 1})")),
                h);
  const Vec3d start = rig.positions()[5].xyz().to<double>(), target{0.4, -0.3, 0.25};
  rig.hold(5, target, rate, 100);
  int steps = 0;
  for (const int more : {1, 1, 20, 100, 300}) {
    rig.advance(static_cast<std::uint32_t>(more));
    steps += more;
    const Vec3d expected = target + std::pow(1 - rate * h, steps) * (start - target);
    // A step rounds a place below 1 m; what is left of a rounding falls as (1 - r h)^n, so 1 / r h add up.
    CHECK(length(rig.positions()[5].xyz().to<double>() - expected) < 6e-8 * 2 / (rate * h));
  }
}

TEST_CASE("a hanging node stretches its spring by m g / k") {
  GpuFixture fixture;
  // 2 x 2 nodes, the upper two pinned. Each lower node hangs by one boundary spring (half of 100 N/m) and
  // weighs a quarter of 0.4 kg: 0.1 * 9.81 / 50 = 19.62 mm.
  for (const char* forces : {"node_centric", "spring_centric"}) {
    SolverRig rig(
        fixture.device(),
        scene_of(R"("solver": {"kind": "mass_spring", "forces": ")" + std::string(forces) + R"("}, )" +
                 grid(2, 2, 1, 1,
                      R"("density": 0.4, "damping": 0.8, "pins": ["top"],
                   "stiffness": {"structural": 100, "shear": 0, "bend": 0})")),
        1e-3);
    const auto start = rig.positions();
    rig.advance(20000);  // 20 s: forty decay times of 2 m / c = 0.5 s
    const auto end = rig.positions();
    for (const std::size_t node : {2UL, 3UL})
      CHECK(static_cast<double>(start[node].y - end[node].y) ==
            doctest::Approx(0.01962).epsilon(1e-3).scale(0));
  }
}

TEST_CASE("a strip under its own weight lengthens by the sum over its springs, near rho g L² / 2 E") {
  GpuFixture fixture;
  const std::uint32_t ny = 41;
  const double density = 0.2, length = 2, k = 200;  // structural springs alone: E = k [N/m]
  SolverRig rig(fixture.device(),
                scene_of(R"("drag": 3, )" + grid(5, ny, 0.2, length,
                                                 R"("density": 0.2, "damping": 0, "pins": ["top"],
                 "stiffness": {"structural": 200, "shear": 0, "bend": 0})")),
                1e-3);
  rig.advance(12000);  // 12 s; the slowest mode decays as exp(-1.5 t)
  const auto end = rig.positions();
  // Spring n of a column carries the ny - n - 1 rows below it and half the last: a row weighs density·a·g per
  // width.
  const double a = length / (ny - 1);
  double elongation = 0;
  for (std::uint32_t n = 0; n + 1 < ny; ++n) elongation += density * a * a * kGravity * (ny - 1.5 - n) / k;
  const double continuum = density * kGravity * length * length / (2 * k);
  CHECK(elongation == doctest::Approx(continuum).epsilon(2.0 / ny).scale(0));
  for (std::uint32_t i = 0; i < 5; ++i)
    CHECK(static_cast<double>(end[i].y - end[(ny - 1) * 5 + i].y) - length ==
          doctest::Approx(elongation).epsilon(2e-3).scale(0));
}

TEST_CASE(
    "a stretched lattice has the moduli E = k'(k' + 2 s) / (k' + s) and nu = s / (k' + s) with k' = k + 4 "
    "b") {
  GpuFixture fixture;
  for (const auto& [structural, shear, bend] : {std::array{400.0, 200.0, 0.0}, {300.0, 100.0, 25.0}}) {
    const std::uint32_t nx = 61, ny = 13;
    const double width = 3.0, height = 0.6, strain = 0.002, a = width / (nx - 1);
    const std::string stiffness = R"("stiffness": {"structural": )" + std::to_string(structural) +
                                  R"(, "shear": )" + std::to_string(shear) + R"(, "bend": )" +
                                  std::to_string(bend) + "}";
    SolverRig rig(
        fixture.device(),
        scene_of(R"("gravity": [0, 0, 0], "drag": 8, )" +
                 grid(nx, ny, width, height,
                      R"("density": 0.2, "damping": 0.01, "pins": ["left", "right"], )" + stiffness)),
        4e-4);
    auto position = rig.positions();
    for (Vec4f& x : position) x.x *= static_cast<float>(1 + strain);  // both ends fixed, stretched
    rig.set(position, std::vector<Vec4f>(position.size()));
    rig.advance(7000);  // 2.8 s of drag 8 / s
    position = rig.positions();
    // In the middle third, away from the clamped ends.
    const std::uint32_t left = nx / 3, right = 2 * nx / 3;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return position[j * nx + i].xyz().to<double>(); };
    const double along = (at(right, ny / 2).x - at(left, ny / 2).x) / (a * (right - left)) - 1;
    double across = 0;
    for (std::uint32_t i = left; i <= right; ++i) across += (at(i, 0).y - at(i, ny - 1).y) / height - 1;
    across /= right - left + 1;
    // The tension through a cut between two columns: springs that cross it.
    const auto system = rig.reference();
    double force = 0;
    for (const auto& spring : system.springs) {
      const std::uint32_t ia = spring.node_a % nx, ib = spring.node_b % nx, cut = nx / 2;
      const std::uint32_t low = ia < ib ? ia : ib, high = ia < ib ? ib : ia;
      if (low > cut || high <= cut) continue;
      const Vec3d span = system.position[spring.node_b] - system.position[spring.node_a];
      force += spring.stiffness * (weft::length(span) - spring.rest_length) * std::abs(span.x) /
               weft::length(span);
    }
    const double k = structural + 4 * bend;
    const double modulus = k * (k + 2 * shear) / (k + shear), poisson = shear / (k + shear);
    CAPTURE(structural);
    CAPTURE(shear);
    CAPTURE(bend);
    // Strain 0.2 % leaves terms of second order of that size; the free sides bend differently in a row of
    // springs.
    CHECK(force / height / along == doctest::Approx(modulus).epsilon(0.01).scale(0));
    CHECK(-across / along == doctest::Approx(poisson).epsilon(0.02).scale(0));
  }
}

TEST_CASE("a standing wave swings as the discrete chain says: omega = 2 √(k/m) sin(q a / 2)") {
  GpuFixture fixture;
  // Structural springs alone: every row is a chain with free ends of half the mass, whose modes are cos(p π i
  // / (n-1)).
  const std::uint32_t n = 33;
  const double density = 0.2, k = 100, a = 1.0 / 32, amplitude = 1e-3;
  const double m = density * a * a, h = 2e-4;
  for (const int mode : {1, 3, 8}) {
    SolverRig rig(
        fixture.device(),
        scene_of(
            R"("gravity": [0, 0, 0], )" +
            grid(n, 5, 1, 4.0 / 32,
                 R"("density": 0.2, "damping": 0, "stiffness": {"structural": 100, "shear": 0, "bend": 0})")),
        h);
    const auto rest = rig.positions();
    auto position = rest;
    for (std::size_t i = 0; i < position.size(); ++i)
      position[i].x +=
          static_cast<float>(amplitude * std::cos(kPi * mode * static_cast<double>(i % n) / (n - 1)));
    rig.set(position, std::vector<Vec4f>(position.size()));
    const double omega = 2 * std::sqrt(k / m) * std::sin(kPi * mode / (2.0 * (n - 1)));
    // Semi-implicit Euler of x'' = -ω² x from rest: x_s = A (cos sθ - tan(θ/2) sin sθ), sin(θ/2) = ω h / 2.
    const double theta = 2 * std::asin(omega * h / 2);
    const int steps = 700;
    rig.advance(steps);
    const double expected =
        amplitude * (std::cos(steps * theta) - std::tan(theta / 2) * std::sin(steps * theta));
    const auto end = rig.positions();
    CAPTURE(mode);
    for (std::size_t i = 0; i < end.size(); ++i) {
      const double shape = std::cos(kPi * mode * static_cast<double>(i % n) / (n - 1));
      // A spring's length is known to 2^-25 of 1/2 m (where its nodes stand), 3e-8 m: 3e-5 of the amplitude;
      // over 700 steps such errors add up as a random walk that the chain spreads.
      CHECK(std::abs(static_cast<double>(end[i].x - rest[i].x) - expected * shape) < 4e-3 * amplitude);
    }
  }
}

TEST_CASE("the energy of an undamped sheet does not drift") {
  GpuFixture fixture;
  const auto scene = scene_of(
      R"("gravity": [0, 0, 0], )" +
      grid(16, 16, 1, 1,
           R"("density": 0.2, "damping": 0, "stiffness": {"structural": 500, "shear": 200, "bend": 20})"));
  auto host = build_model(scene, {{}});
  const StepLimit limit = mass_spring_step_limit(*host, 0);
  // Semi-implicit Euler keeps an energy that differs from the true one by O(ω h) of it: at a tenth of the
  // limit the true one swings by a few per cent and its mean over many periods stands still.
  SolverRig rig(fixture.device(), scene, 0.1 * limit.largest_step);
  rig.perturb(11, 0.002, 0.3);
  const auto mean_energy = [&](int windows) {
    double sum = 0;
    for (int w = 0; w < windows; ++w) {
      rig.advance(37);
      sum += reference::energy(rig.reference());
    }
    return sum / windows;
  };
  const double first = mean_energy(20);
  rig.advance(20000);
  const double last = mean_energy(20);
  CHECK(last == doctest::Approx(first).epsilon(0.01).scale(0));
}
