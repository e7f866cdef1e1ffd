// The reference in motion: orders, invariants, closed forms.
#include <algorithm>
#include <string>

#include "element/reference/equilibrium.hpp"
#include "reference_sheets.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

constexpr std::array kSchemes = {Scheme::Midpoint, Scheme::Bdf2};
std::string name_of(Scheme scheme) { return scheme == Scheme::Midpoint ? "midpoint" : "BDF2"; }

/// Takes all steps, or ends the test.
void run(Motion& motion, double time, int steps) {
  for (int n = 0; n < steps; ++n) {
    const auto report = motion.advance(time / steps);
    REQUIRE_MESSAGE(report, (report ? "" : report.error().message));
  }
}

struct Momentum {
  Vec3d linear, angular;  // [kg m/s], [kg m²/s]
};
Momentum momentum_of(const Motion& motion) {
  Momentum sum;
  const SheetState& s = motion.state();
  for (std::size_t v = 0; v < s.position.size(); ++v) {
    const Vec3d one = motion.energy().mass()[v] * s.velocity[v];
    sum.linear += one;
    sum.angular += cross(s.position[v], one);
  }
  return sum;
}

/// A free sheet that is bent, flies, turns and swings: one way in its whole, another in its shape.
struct Tumbling {
  Sheet sheet;
  SheetState start;

  explicit Tumbling(Pattern kind = Pattern::Irregular) {
    const PatternSheet pattern = pattern_sheet(kind, 0.3, 4, 3);
    sheet = cloth_of(pattern);
    for (const Vec3d& p : pattern.position) {
      start.position.push_back(p + Vec3d{0, 0, 0.02 * std::cos(10 * p.x + 4 * p.y)});
      start.velocity.push_back(Vec3d{0.3, -0.2, 0.5} + cross(Vec3d{2, 5, -3}, p - Vec3d{0.1, 0.1, 0}) +
                               Vec3d{0, 0, 0.2 * std::sin(12 * p.y)});
    }
  }
};

/// Hangs down by its edge x = 0, stretched by its weight, and swings out of its plane in air that slows it.
Motion swinging(Scheme scheme, double delay) {
  const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 0.4, 5, 3);
  Sheet sheet = cloth_of(pattern);
  sheet.held = held_before_zero(pattern.position);
  sheet.membrane.delay = delay;
  sheet.gravity = {9.81, 0, 0};
  sheet.drag = 0.5;
  const auto hanging = equilibrium(SheetEnergy(sheet), pattern.position);
  REQUIRE_MESSAGE(hanging, (hanging ? "" : hanging.error().message));
  SheetState start{hanging->position, {}};
  for (const Vec3d& p : start.position) start.velocity.push_back({0, 0, 3 * p.x * (1 + p.y)});
  return {sheet, start, scheme, {1e-7}};
}

}  // namespace

TEST_CASE("a hanging sheet swings to the second order of the step, by both schemes to the same places") {
  // Without damping the fastest waves, of some 1500 rad/s, must be resolved by several steps; a delay damps them.
  struct Run {
    double delay, time;  // [s]
    int steps;           // the fewest
  };
  for (const auto& [delay, time, steps] : {Run{0, 0.05, 200}, Run{0.01, 0.3, 60}}) {
    std::array<std::vector<Vec3d>, 2> end;
    std::array<double, 2> last{};
    for (std::size_t s = 0; s < kSchemes.size(); ++s) {
      std::array<std::vector<Vec3d>, 3> x;
      for (std::size_t level = 0; level < x.size(); ++level) {
        Motion motion = swinging(kSchemes[s], delay);
        run(motion, time, steps << level);
        x[level] = motion.state().position;
      }
      const double coarse = largest_difference(x[0], x[1]), fine = largest_difference(x[1], x[2]);
      MESSAGE(name_of(kSchemes[s]) << ", delay " << delay << " s: differences " << coarse << ", " << fine
                                   << " m, order " << order_of(coarse, fine));
      CHECK(order_of(coarse, fine) > 1.5);  // nearer to the second order than to the first
      end[s] = x[2];
      last[s] = fine;
    }
    // At the second order a third of the last difference is what is left.
    CHECK(largest_difference(end[0], end[1]) < last[0] + last[1]);
  }
}

TEST_CASE("a sheet without force is slowed by drag as e to the -c t, with equal and unequal steps") {
  constexpr double kDrag = 2, kTime = 1;
  const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 1, 3, 2);
  Sheet sheet = cloth_of(pattern);
  sheet.drag = kDrag;
  for (const Scheme scheme : kSchemes)
    for (const std::array cycle : {std::array{1.0, 1.0, 1.0}, {0.5, 0.7, 1.8}}) {
      std::array<double, 2> error{};
      for (std::size_t level = 0; level < error.size(); ++level) {
        const int cycles = 7 << level;
        Motion motion(sheet, {pattern.position, std::vector(sheet.rest.size(), Vec3d{1, 2, -2})}, scheme,
                      {1e-9});
        for (int n = 0; n < cycles; ++n)
          for (const double part : cycle) REQUIRE(motion.advance(part / 3 * kTime / cycles));
        const double way = (1 - std::exp(-kDrag * kTime)) / kDrag;
        error[level] = length(motion.state().position[0] - pattern.position[0] - way * Vec3d{1, 2, -2}) +
                       length(motion.state().velocity[0] - std::exp(-kDrag * kTime) * Vec3d{1, 2, -2});
      }
      MESSAGE(name_of(scheme) << ", first step " << cycle[0] << ": errors " << error[0] << ", " << error[1]
                              << ", order " << order_of(error[0], error[1]));
      CHECK(order_of(error[0], error[1]) > 1.5);
    }
}

TEST_CASE("small motions are linear, and take one step of Newton's method") {
  // Stiffness, damping, drag and mass act together: one step is enough only by the whole derivative of all forces.
  // Strains of 1e-8 leave 1e-8 of a residual of some 1e-4 m/s².
  const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 0.4, 5, 3);
  Sheet sheet = cloth_of(pattern);
  sheet.held = held_before_zero(pattern.position);
  sheet.membrane.delay = 0.01;
  sheet.drag = 20;
  SheetState start{pattern.position, {}};
  Random random(6);
  for (std::size_t v = 0; v < start.position.size(); ++v)
    start.velocity.push_back(random_vector(random, 1e-7));
  for (const Scheme scheme : kSchemes) {
    Motion motion(sheet, start, scheme, {1e-9});
    for (int n = 0; n < 10; ++n) {
      const auto report = motion.advance(0.003);
      REQUIRE_MESSAGE(report, (report ? "" : report.error().message));
      CHECK(report->steps == 1);
    }
  }
}

TEST_CASE(
    "a wave along a strip whose end is shaken is that of a rod, to the second order of cells and steps") {
  // u = a cos(k (L - x)) / cos(k L) sin(ω t) with ω = k √(E/ρ): at the clamp a sin(ω t), free at x = L.
  constexpr double kWave = 2, kModulus = 20, kDensity = 0.2, kReach = 1e-3;  // [1/m], [N/m], [kg/m²], [m]
  const double omega = kWave * std::sqrt(kModulus / kDensity);
  for (const Scheme scheme : kSchemes) {
    std::array<double, 3> error{};
    for (std::size_t level = 0; level < error.size(); ++level) {
      const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 1, 8 << level, 2);
      Sheet sheet = cloth_of(pattern);
      sheet.warp = {1, 0, 0};
      sheet.held = held_before_zero(pattern.position);
      sheet.membrane.stiffness = Stiffness::of(Moduli::isotropic(kModulus, 0));
      sheet.density = kDensity;
      const auto reach = [&](double x) { return kReach * std::cos(kWave * (1 - x)) / std::cos(kWave); };
      sheet.place = [&](std::uint32_t v, double t) {
        return Placed{pattern.position[v] + Vec3d{kReach * std::sin(omega * t), 0, 0},
                      {kReach * omega * std::cos(omega * t), 0, 0}};
      };
      SheetState start{pattern.position, {}};
      for (const Vec3d& p : pattern.position) start.velocity.push_back({omega * reach(p.x), 0, 0});
      Motion motion(sheet, start, scheme);
      run(motion, 0.5, 50 << level);
      double sum = 0;
      for (std::size_t v = 0; v < pattern.position.size(); ++v) {
        const Vec3d& p = pattern.position[v];
        const Vec3d exact = p + Vec3d{reach(p.x) * std::sin(omega * 0.5), 0, 0};
        const Vec3d off = motion.state().position[v] - exact;
        sum += dot(off, off);
      }
      error[level] = std::sqrt(sum / static_cast<double>(pattern.position.size())) / kReach;
    }
    MESSAGE(name_of(scheme) << ": errors " << error[0] << ", " << error[1] << ", " << error[2]
                            << " of the shake, orders " << order_of(error[0], error[1]) << ", "
                            << order_of(error[1], error[2]));
    CHECK(order_of(error[0], error[2]) / 2 > 1.5);
  }
}

TEST_CASE("a free sheet that tumbles keeps its momentum, and by the midpoint rule its angular momentum") {
  constexpr double kTime = 0.4, kResidual = 1e-7;  // [s], [m/s²]
  struct Run {
    Scheme scheme;
    double delay;  // [s]
  };
  for (const auto& [scheme, delay] :
       {Run{Scheme::Midpoint, 0}, Run{Scheme::Midpoint, 0.005}, Run{Scheme::Bdf2, 0.005}}) {
    std::array<double, 2> drift{};
    for (std::size_t level = 0; level < 2; ++level) {
      Tumbling tumbling;
      tumbling.sheet.membrane.delay = delay;
      Motion motion(tumbling.sheet, tumbling.start, scheme, {kResidual});
      const Momentum before = momentum_of(motion);
      double mass = 0, radius = 0;
      for (const double m : motion.energy().mass()) mass += m;
      run(motion, kTime, 160 << level);
      const Momentum after = momentum_of(motion);
      for (const Vec3d& p : motion.state().position) radius = std::max(radius, length(p));
      // What Newton leaves acts like a force of up to m r on each node, all the time.
      const double impulse = mass * kResidual * kTime;
      CHECK(length(after.linear - before.linear) < impulse);
      drift[level] = length(after.angular - before.angular);
      if (scheme == Scheme::Midpoint) CHECK(drift[level] < impulse * radius);
      MESSAGE(name_of(scheme) << ", delay " << delay << " s: momentum drifts by "
                              << length(after.linear - before.linear) / length(before.linear)
                              << ", angular momentum by " << drift[level] / length(before.angular));
    }
    if (scheme == Scheme::Bdf2) CHECK(order_of(drift[0], drift[1]) > 1.5);  // the scheme's, at least
  }
}

TEST_CASE(
    "a free sheet's energy never rises above its first by BDF2, and is of the second order by the midpoint "
    "rule") {
  constexpr double kTime = 0.2;
  for (const Scheme scheme : kSchemes) {
    std::array<double, 3> off{};
    for (std::size_t level = 0; level < off.size(); ++level) {
      const Tumbling tumbling;
      Motion motion(tumbling.sheet, tumbling.start, scheme, {1e-7});
      const double start = motion.total_energy();
      double most = start, least = start;
      const int steps = 200 << level;
      for (int n = 0; n < steps; ++n) {
        REQUIRE(motion.advance(kTime / steps));
        most = std::max(most, motion.total_energy());
        least = std::min(least, motion.total_energy());
      }
      off[level] = std::max(most - start, start - least) / start;
      if (scheme == Scheme::Bdf2) CHECK(most == start);
    }
    MESSAGE(name_of(scheme) << ": energy off by " << off[0] << ", " << off[1] << ", " << off[2] << ", orders "
                            << order_of(off[0], off[1]) << ", " << order_of(off[1], off[2]));
    if (scheme == Scheme::Midpoint) CHECK(order_of(off[1], off[2]) > 1.5);
  }
  for (const int steps : {4, 10, 20, 40}) {  // where steps are too long to be right
    const Tumbling tumbling;
    Motion motion(tumbling.sheet, tumbling.start, Scheme::Bdf2);
    const double start = motion.total_energy();
    for (int n = 0; n < steps; ++n) {
      REQUIRE(motion.advance(kTime / steps));
      CHECK(motion.total_energy() <= start);
    }
  }
}

TEST_CASE("a sheet that is held and pulled along another way moves as the first one turned") {
  constexpr double kResidual = 1e-8, kTime = 0.1;
  const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 0.4, 5, 3);
  const Vec3d shift{0.4, -1, 2};
  for (const Scheme scheme : kSchemes) {
    Sheet sheet = cloth_of(pattern);
    sheet.held = held_before_zero(pattern.position);
    sheet.membrane.delay = 0.01;
    sheet.gravity = {0, 0, -9.81};
    Motion motion(sheet, {pattern.position, std::vector<Vec3d>(sheet.rest.size())}, scheme, {kResidual});
    Sheet turned = sheet;
    for (Vec3d& p : turned.rest) p = kTurn(p) + shift;
    turned.warp = kTurn(sheet.warp);
    turned.gravity = kTurn(sheet.gravity);
    Motion other(turned, {turned.rest, std::vector<Vec3d>(sheet.rest.size())}, scheme, {kResidual});
    run(motion, kTime, 50);
    run(other, kTime, 50);
    std::vector<Vec3d> expected;
    for (const Vec3d& p : motion.state().position) expected.push_back(kTurn(p) + shift);
    // A force r on a node by its mass moves it by r t²/2; its neighbours pull it back, and both runs err.
    CHECK(largest_difference(other.state().position, expected) < kResidual * kTime * kTime);
  }
}

TEST_CASE("a sheet that is slowed comes to rest at its equilibrium") {
  const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 0.4, 6, 4);
  Sheet sheet = cloth_of(pattern);
  sheet.held = held_before_zero(pattern.position);
  sheet.gravity = {0, 0, -9.81};
  sheet.drag = 20;
  Motion motion(sheet, {pattern.position, std::vector<Vec3d>(sheet.rest.size())}, Scheme::Bdf2, {1e-8});
  run(motion, 20, 400);
  const auto found = equilibrium(motion.energy(), pattern.position, {1e-8});
  REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
  CHECK(found->stable);
  MESSAGE("difference " << largest_difference(motion.state().position, found->position) << " m, "
                        << found->report.steps << " steps, " << found->report.positive_steps
                        << " with the positive matrix");
  // A residual r leaves a mode of rate ω off by r/ω². The slowest is a pendulum's, of (g/L)^(1/2) = 5 rad/s, and 20 s
  // are 25 of its decay times. Ten such modes may add up.
  CHECK(largest_difference(motion.state().position, found->position) < 10 * 1e-8 / 25);
}

TEST_CASE("sheets of one cloth move alike on every pattern, the more so the finer their triangles") {
  constexpr double kTime = 0.15;
  std::array<double, 2> apart{};
  for (std::size_t level = 0; level < apart.size(); ++level) {
    std::vector<std::array<Vec3d, 2>> ends;
    for (const Pattern kind : kPatterns) {
      PatternSheet pattern = pattern_sheet(kind, 0.4, level == 0 ? 4 : 12, level == 0 ? 2 : 6);
      const double scale = 0.25 / pattern.width;
      for (Vec3d& p : pattern.position) p.y *= scale;
      Sheet sheet = cloth_of(pattern);
      sheet.held = held_before_zero(pattern.position);
      sheet.membrane.delay = 0.01;
      sheet.bending = Stiffness::of({2e-3, 1e-3, 0.2, 6e-4});  // it falls off over (B/w)^(1/3) = 0.1 m
      sheet.gravity = {0, 0, -9.81};
      Motion motion(sheet, {pattern.position, std::vector<Vec3d>(sheet.rest.size())}, Scheme::Midpoint);
      run(motion, kTime, 60);
      std::array<Vec3d, 2> corners;  // of the free end
      for (std::size_t v = 0; v < sheet.rest.size(); ++v)
        if (sheet.rest[v].x > 0.4 - 1e-9) {
          if (sheet.rest[v].y < 1e-9) corners[0] = motion.state().position[v];
          if (sheet.rest[v].y > 0.25 - 1e-9) corners[1] = motion.state().position[v];
        }
      ends.push_back(corners);
    }
    for (const auto& one : ends)
      for (const auto& other : ends)
        for (std::size_t k = 0; k < 2; ++k) apart[level] = std::max(apart[level], length(one[k] - other[k]));
  }
  MESSAGE("corners apart by " << apart[0] << ", " << apart[1] << " m, order "
                              << std::log(apart[0] / apart[1]) / std::log(3.0));
  CHECK(apart[1] < apart[0] / 3);  // the first order, at least
}

TEST_CASE("a step that Newton's method does not solve says what is left of what, and changes nothing") {
  const Tumbling tumbling;
  Motion motion(tumbling.sheet, tumbling.start, Scheme::Midpoint, {1e-7, 0});
  const auto report = motion.advance(0.01);
  REQUIRE(!report);
  CHECK(report.error().kind == ErrorKind::Diverged);
  CHECK(report.error().message.find("After 0 steps Newton's method leaves a residual of ") == 0);
  CHECK(report.error().message.find(" m/s², above 1e-07 m/s².") != std::string::npos);
  CHECK(motion.state().time == 0);
  CHECK(motion.state().position == tumbling.start.position);
}
