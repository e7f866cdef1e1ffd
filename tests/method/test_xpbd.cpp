// XPBD over springs: the kernels against the same substep in double, and laws that hold without a computer. What every
// method must do: test_every_method.cpp; in a world: tests/sim/test_every_method.cpp.
#include <algorithm>
#include <cmath>
#include <complex>

#include "gpu/gpu_fixture.hpp"
#include "mesh/primitives.hpp"
#include "method/method.hpp"
#include "method/projection/sag.hpp"
#include "method/stepper.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;        // [m/s²]
constexpr double kUlp = 1.0 / 16777216;  // 2^-24: a relative rounding error of f32
constexpr double kPi = 3.14159265358979323846;

std::string xpbd(int iterations = 1) {
  return R"("solver": {"kind": "xpbd", "iterations": )" + std::to_string(iterations) + "}, ";
}

std::string grid(const std::string& nodes, const std::string& size, const std::string& more) {
  return R"("cloths": [{"grid": )" + nodes + R"(, "size": )" + size + ", " + more + "}]";
}

/// One substep against double.
void check_substep(SolverRig& rig, const scene::Scene& scene) {
  // Projecting a spring rounds its span (6 roundings of its length), the tension's difference (2), quotient and
  // product (4) and two sums of ways: 16 of its length at most. Projecting brings two states no further apart,
  // measured by mass, but for what a pressed spring's turn adds; so of the roundings of all springs, whose signs
  // differ, the root of their number is left, over all nodes together; twice that for pressed ones.
  const reference::MassSpringSystem before = rig.reference();
  double longest = 0;
  for (const auto& s : before.springs)
    longest =
        std::max({longest, s.rest_length, length(before.position[s.node_b] - before.position[s.node_a])});
  const double tolerance = 2 * 16 * kUlp * longest *
                           std::sqrt(static_cast<double>(before.springs.size()) * scene.solver.iterations);
  const auto exact = exact_after(rig, scene, 1);
  rig.advance(1);
  const auto position = rig.positions(), velocity = rig.velocities();
  double way = 0, worst = 0, worst_velocity = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    way = std::max(way, length(exact.position[i] - before.position[i]));
    worst = std::max(worst, length(position[i].xyz().to<double>() - exact.position[i]));
    worst_velocity = std::max(worst_velocity, length(velocity[i].xyz().to<double>() - exact.velocity[i]));
  }
  MESSAGE(position.size() << " nodes: " << worst << " m and " << worst_velocity << " m/s off after a way of "
                          << way << " m; allowed " << tolerance << " m");
  CHECK(worst < tolerance + 4 * kUlp);  // places within 4 m round once more
  CHECK(worst_velocity < tolerance / rig.dt() + 4 * kUlp * way / rig.dt());
  CHECK(tolerance < 0.02 * way);  // a spring that is left out, or a weight, is seen
}

/// A node under another, by one boundary spring: half of 100 N/m, and a quarter of 0.4 kg.
constexpr double kNodeStiffness = 50, kNodeMass = 0.1;
std::string hung_nodes(double damping) {
  return grid("[2, 2]", "[1, 1]",
              R"("density": 0.4, "pins": ["top"], "stiffness": {"structural": 100, "shear": 0, "bend": 0},
                 "damping": )" +
                  std::to_string(damping));
}

/// By how much the strip of `column` below hangs longer than its springs say, as a part of its length.
constexpr std::uint32_t kRows = 21;
constexpr double kStripLength = 1, kStripDensity = 0.2, kStripStiffness = 2000;
struct Sag {
  double over;   // beyond the springs' own elongation
  double bound;  // equation (7) of docs/solvers/xpbd.md
};
Sag sag_of(gpu::Device& device, double h, int iterations) {
  const double a = kStripLength / (kRows - 1);
  const auto scene = scene_of(xpbd(iterations) + R"("drag": 10, )" +
                              grid("[5, 21]", "[0.2, 1]",
                                   R"("density": 0.2, "damping": 0, "pins": ["top"],
                                      "stiffness": {"structural": 2000, "shear": 0, "bend": 0})"));
  SolverRig rig(device, scene, h);
  // A column hangs from the springs' own elongation: row n's spring carries the rows below it and half the last.
  std::vector<double> drop(kRows, 0.0);
  double weights = 0;  // sum over the springs of force × inverse masses
  for (std::uint32_t n = 0; n + 1 < kRows; ++n) {
    const double force = kStripDensity * a * a * kGravity * (kRows - 1.5 - n);  // of a whole column [N]
    const double mass = kStripDensity * a * a;
    drop[n + 1] = drop[n] + force / kStripStiffness;
    weights += force * ((n == 0 ? 0 : 1 / mass) + (n + 2 == kRows ? 2 : 1) / mass);
  }
  auto position = rig.positions();
  for (std::size_t i = 0; i < position.size(); ++i) position[i].y -= static_cast<float>(drop[i / 5]);
  rig.set(position, std::vector<Vec4f>(position.size()));
  const float top = position[2].y;
  rig.advance(static_cast<std::uint32_t>(
      std::lround(1 / h)));  // swings fall as exp(-5 t) by drag, and faster by the step
  const double found = static_cast<double>(top - rig.positions()[(kRows - 1) * 5 + 2].y) - kStripLength;
  return {(found - drop.back()) / kStripLength, h * h * weights / kStripLength};
}

Vec3d angular_momentum(const reference::MassSpringSystem& system) {
  Vec3d sum;
  for (std::size_t i = 0; i < system.position.size(); ++i)
    sum += 1 / system.inverse_mass[i] * cross(system.position[i], system.velocity[i]);
  return sum;
}

const std::string kSoft = R"("density": 0.2, "damping": 0.002,
    "stiffness": {"structural": 50, "shear": 20, "bend": 2})";
const std::string kLoose = R"("density": 0.2, "damping": 0.02,
    "stiffness": {"structural": 500, "shear": 200, "bend": 20})";

}  // namespace

TEST_CASE(
    "an xpbd substep equals the reference within its rounding, on grids of any size, with one sweep or "
    "three") {
  GpuFixture fixture;
  for (const char* nodes : {"[2, 2]", "[2, 5]", "[7, 3]", "[13, 29]", "[40, 31]"})
    for (const int iterations : {1, 3}) {
      CAPTURE(nodes);
      CAPTURE(iterations);
      const auto scene = scene_of(
          xpbd(iterations) + grid(nodes, "[1.0, 0.8]", kLoose + R"(, "pins": ["top_left", "top_right"])"));
      SolverRig rig(fixture.device(), scene, 2e-3);
      rig.perturb(5, 0.008, 1.0);
      check_substep(rig, scene);
    }
}

TEST_CASE("an xpbd substep equals the reference on meshes, and on two cloths at once") {
  GpuFixture fixture;
  const std::string cloth = R"({"mesh": "a.obj", "pins": [{"nodes": [3]}], )" + kLoose + "}";
  for (const auto& mesh : {mesh::make_sphere(12, 9), sheet_mesh(9, 14, 1, 1.5)}) {
    const auto one = scene_of(xpbd() + R"("cloths": [)" + cloth + "]");
    SolverRig rig(fixture.device(), one, 2e-3, {mesh});
    rig.perturb(5, 0.01, 0.5);
    check_substep(rig, one);
    const auto two =
        scene_of(xpbd(2) + R"("cloths": [{"grid": [9, 6], "size": [1, 1], )" + kLoose + "}, " + cloth + "]");
    SolverRig both(fixture.device(), two, 2e-3, {{}, mesh});
    both.perturb(6, 0.01, 0.5);
    check_substep(both, two);
  }
}

TEST_CASE("an xpbd substep in gusts, with held nodes, equals the reference") {
  GpuFixture fixture;
  const auto scene = scene_of(xpbd() + R"("drag": 7, "wind": {"velocity": [-2, 1.5, 6], "gusts": 0.9}, )" +
                              grid("[9, 11]", "[1.0, 0.8]", kLoose + R"(, "pins": ["top_left"])"));
  SolverRig rig(fixture.device(), scene, 2e-3);
  rig.perturb(6, 0.008, 1.0);
  rig.hold(20, {0.3, 0.1, 0.2}, 20, 10);
  rig.hold(0, {0.3, 0.1, 0.2}, 20, 10);  // pinned
  rig.hold(31, {5, -2, 0.2}, 20, 10);    // cut to the speed
  const Vec4f pinned = rig.positions()[0];
  check_substep(rig, scene);
  CHECK(rig.positions()[0] == pinned);
  CHECK(length(rig.velocities()[31].xyz()) == doctest::Approx(10));
}

TEST_CASE("a loose xpbd sheet falls as y = y0 - g h² n (n + 1) / 2, within the rounding of its steps") {
  GpuFixture fixture;
  const double h = 1.0 / 256;  // exact in f32
  SolverRig rig(fixture.device(), scene_of(xpbd() + grid("[5, 4]", "[1, 1]", R"("density": 0.2, "damping": 0,
                    "stiffness": {"structural": 10, "shear": 5, "bend": 1})")),
                h);
  const auto start = rig.positions();
  const int steps = 100;
  rig.advance(steps);
  const auto end = rig.positions();
  const double fall = kGravity * h * h * steps * (steps + 1) / 2;
  for (std::size_t i = 0; i < end.size(); ++i) {
    // As for semi-implicit steps: each rounds a position below 1 m and a velocity below 4 m/s.
    CHECK(std::abs(static_cast<double>(start[i].y) - fall - static_cast<double>(end[i].y)) <
          steps * (1.2e-7 + h * 4 * 1.2e-7) * 4);
    CHECK(std::abs(end[i].x - start[i].x) < 1e-6F);
  }
}

TEST_CASE("one xpbd spring is backward Euler: a hung node swings as z^n, z = 1 / (1 - h μ), damped or not") {
  GpuFixture fixture;
  for (const double damping : {0.0, 0.8}) {
    for (const double h : {1e-3, 2.5e-4}) {
      CAPTURE(damping);
      CAPTURE(h);
      SolverRig rig(fixture.device(), scene_of(xpbd() + hung_nodes(damping)), h);
      // Half the damping acts, as half the stiffness: μ² m + μ c/2 + k = 0.
      const std::complex<double> root = std::sqrt(
          std::complex(damping * damping / 16 / (kNodeMass * kNodeMass) - kNodeStiffness / kNodeMass));
      const std::complex<double> mu = -damping / 4 / kNodeMass + root, nu = -damping / 4 / kNodeMass - root;
      const double sag = kNodeMass * kGravity / kNodeStiffness, amplitude = 0.1;
      auto position = rig.positions();
      for (const std::size_t node : {2UL, 3UL}) position[node].y -= static_cast<float>(sag + amplitude);
      const double rest = static_cast<double>(position[2].y) + amplitude;
      rig.set(position, std::vector<Vec4f>(position.size()));
      const double period = 2 * kPi * std::sqrt(kNodeMass / kNodeStiffness);
      const int stride = static_cast<int>(period / h / 32);
      int turns = 0;  // upwards through rest
      double before = -amplitude;
      for (int step = stride; step * h < 3.5 * period; step += stride) {
        rig.advance(static_cast<std::uint32_t>(stride));
        const double now = static_cast<double>(rig.positions()[2].y) - rest;
        const std::complex<double> expected =
            -amplitude * (nu * std::pow(1.0 - h * mu, -step) - mu * std::pow(1.0 - h * nu, -step)) /
            (nu - mu);
        // A step rounds the elongation of a spring of 1 m, and h² k/m of that goes into the way, n²/2 times in n steps
        // if it is always the same; and it rounds a place of about 1 m.
        const double of_springs = 4 * kUlp * 0.5 * step * step * h * h * kNodeStiffness / kNodeMass;
        CHECK(std::abs(now - expected.real()) < of_springs + step * kUlp);
        if (before < 0 && now >= 0) ++turns;
        before = now;
      }
      CHECK(turns == 4);  // after a quarter of 2 π √(m/k), 1 1/4, 2 1/4 and 3 1/4 of it
    }
  }
}

TEST_CASE("an xpbd node hangs by m g / k at any step and any number of sweeps") {
  GpuFixture fixture;
  for (const auto& [h, iterations] : {std::pair{2e-3, 1}, {8e-3, 1}, {8e-3, 4}}) {
    CAPTURE(h);
    CAPTURE(iterations);
    SolverRig rig(fixture.device(), scene_of(xpbd(iterations) + hung_nodes(4)), h);
    const auto start = rig.positions();
    rig.advance(static_cast<std::uint32_t>(std::lround(2 / h)));  // twenty decay times of 4 m / c
    const auto end = rig.positions();
    for (const std::size_t node : {2UL, 3UL})
      CHECK(static_cast<double>(start[node].y - end[node].y) ==
            doctest::Approx(kNodeMass * kGravity / kNodeStiffness).epsilon(1e-3).scale(0));
  }
}

TEST_CASE(
    "a hanging xpbd strip nears the sum of m g / k as steps shrink and sweeps grow, from within equation 7") {
  GpuFixture fixture;
  const double a = kStripLength / (kRows - 1);
  double before = HUGE_VAL;
  for (const double h : {4e-3, 2e-3, 1e-3}) {
    const Sag sag = sag_of(fixture.device(), h, 1);
    MESSAGE("h " << h << " s, one sweep: " << 100 * sag.over << " % too long, of at most " << 100 * sag.bound
                 << " %");
    CHECK(sag.over > 0);
    CHECK(sag.over < sag.bound);
    CHECK(sag.bound <
          kGravity * h * h * kStripLength / (a * a) / kStripLength * 1.1);  // equation (7) in short
    CHECK(sag.over < 0.3 * before);                                         // of second order: a quarter
    before = sag.over;
  }
  before = HUGE_VAL;
  for (const int iterations : {1, 4, 16}) {
    const Sag sag = sag_of(fixture.device(), 4e-3, iterations);
    MESSAGE("h 0.004 s, " << iterations << " sweeps: " << 100 * sag.over << " % too long");
    CHECK(sag.over < 0.5 * before);
    CHECK(sag.over < sag.bound / iterations);
    before = sag.over;
  }
}

TEST_CASE("a free, stretched xpbd sheet keeps its momentum, and its angular momentum as the step shrinks") {
  GpuFixture fixture;
  double before = HUGE_VAL;
  for (const double h : {2e-4, 1e-4, 5e-5}) {
    SolverRig rig(fixture.device(),
                  scene_of(xpbd() + R"("gravity": [0, 0, 0], )" + grid("[14, 11]", "[1.0, 0.8]", kSoft)), h);
    auto position = rig.positions();
    for (Vec4f& x : position) x = {1.1F * x.x, 1.05F * x.y, x.z, x.w};
    std::vector<Vec4f> velocity;
    for (const Vec4f& x : position)
      velocity.push_back({0.4F - 3 * x.y, 3 * x.x, 0.2F, 0});  // it turns, and drifts
    rig.set(position, velocity);
    const auto start = rig.reference();
    const int steps = static_cast<int>(std::lround(0.08 / h));
    rig.advance(static_cast<std::uint32_t>(steps));
    const auto end = rig.reference();
    Vec3d change;
    double size = 0;
    for (std::size_t i = 0; i < end.position.size(); ++i) {
      change += 1 / end.inverse_mass[i] * (end.velocity[i] - start.velocity[i]);
      size += 1 / end.inverse_mass[i] * length(start.velocity[i]);
    }
    // Both pushes of a spring round by themselves, and the way divided by h: twelve springs a node.
    CHECK(length(change) < std::sqrt(steps) * 14 * 2 * kUlp * size);
    const double lost =
        length(angular_momentum(end) - angular_momentum(start)) / length(angular_momentum(start));
    MESSAGE("h " << h << " s: momentum off by " << length(change) / size << ", angular momentum by " << lost);
    CHECK(lost < 0.6 * before);  // of first order: half
    before = lost;
  }
}

TEST_CASE(
    "auto's xpbd steps follow equation 7: with the resolution, the pull and the sweeps, not the stiffness") {
  const auto step_of = [](const std::string& members, const std::string& cloth) {
    const auto scene = scene_of(members + R"("cloths": [{)" + cloth + "}]");
    auto model = build_model(scene, {{}});
    REQUIRE_OK(model);
    const Method& method = method_of(scene.solver.kind);
    const StepLimit limit = method.step_limit(scene, *model);
    CHECK(limit.largest_step == 0);  // any is stable
    const auto substeps = method.auto_substeps(scene, limit);
    REQUIRE_OK(substeps);
    CHECK(*substeps % 4 == 0);
    CHECK(scene.time.frame / *substeps <= limit.longest_auto_step * (1 + 1e-9));
    return limit.longest_auto_step;
  };
  const auto sheet = [](int nodes, const std::string& more = "") {
    return R"("size": [3, 4], "density": 0.2, "grid": [)" + std::to_string(3 * nodes + 1) + ", " +
           std::to_string(4 * nodes + 1) + "]" + more;
  };
  const double h = step_of(xpbd(), sheet(20));  // cells of 0.05 m, 5 m across
  CHECK(h == doctest::Approx(0.05 * std::sqrt(kSag / (kGravity * 5))));
  CHECK(step_of(xpbd(), sheet(40)) == doctest::Approx(h / 2));
  CHECK(step_of(xpbd(4), sheet(20)) == doctest::Approx(std::min(2 * h, kImplicitStep)));
  CHECK(step_of(xpbd() + R"("gravity": [0, -39.24, 0], )", sheet(20)) == doctest::Approx(h / 2));
  CHECK(step_of(xpbd() + R"("gravity": [0, 0, 0], )", sheet(20)) == doctest::Approx(kImplicitStep));
  CHECK(step_of(xpbd(), sheet(20, R"(, "stiffness": {"structural": 1e6})")) == doctest::Approx(h));
  const auto pull_of = [&](const std::string& members) {
    const double step = step_of(xpbd() + members, sheet(20));
    return 0.05 * 0.05 * kSag / (step * step * 5);
  };
  CHECK(pull_of(R"("drag": 3, "wind": {"velocity": [0, 12, 5]}, )") == doctest::Approx(kGravity + 3 * 13));
  // Air at any angle: no less than what it pushes with at the worst, and hardly more.
  double most = 0;
  for (int degree = 0; degree <= 90; ++degree) {
    const double across = std::sin(degree * M_PI / 180), along = std::cos(degree * M_PI / 180);
    most = std::max(most, std::hypot((0.8 * across + 2 * along) * across, 0.1 * along));
  }
  most *= 0.5 * 1.2 * 13 * 13 / 0.2;
  const double pull = pull_of(
      R"("air": {"density": 1.2, "pressure": 0.8, "lift": 2, "friction": 0.1}, "wind": {"velocity": [0, 12, 5]}, )");
  CHECK(pull > kGravity + most);
  CHECK(pull < kGravity + 1.1 * most);
  // With gusts: by the square of the most that the wind has.
  const auto gusts = [&](double part) {
    return pull_of(R"("air": {}, "wind": {"velocity": [10, 0, 0], "gusts": )" + std::to_string(part) + "}, ");
  };
  CHECK(gusts(0.5) > 1.2 * gusts(0));
}
