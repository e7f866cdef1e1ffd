// Obstacles within the sweeps of vertex block descent, against mechanics, in double.
#include <algorithm>
#include <cmath>

#include "capstan.hpp"
#include "contact/reference/proximity/proximity.hpp"
#include "method/vbd/reference/vbd_stepper.hpp"
#include "rig.hpp"
#include "sheets.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81, kThickness = 0.005;

struct Steps {
  int substeps, sweeps;
};

std::string text(double number) { return std::to_string(number); }

/// A block of 0.2 m over a plane through 0; `slope` [rad] turns gravity instead.
std::string block_on_plane(const Steps& steps, double young, double poisson, double slope, double friction,
                           const std::string& energy = "corotated", double height = 0.105) {
  return R"("gravity": [)" + text(kGravity * std::sin(slope)) + ", " + text(-kGravity * std::cos(slope)) +
         R"(, 0], "time": {"substeps": )" + std::to_string(steps.substeps) +
         R"(}, "solver": {"kind": "vbd", "iterations": )" + std::to_string(steps.sweeps) +
         R"(}, "contact": {"thickness": )" + text(kThickness) +
         R"(}, "bodies": [{"block": [3, 3, 3], "size": [0.2, 0.2, 0.2], "density": 1000, "friction": )" +
         text(friction) + R"(, "material": {"young": )" + text(young) + R"(, "poisson": )" + text(poisson) +
         R"(, "energy": ")" + energy + R"(", "damping": 0.004}, "transform": {"translate": [0, )" +
         text(height) + R"(, 0]}}],
            "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])";
}

double fastest(const reference::Simulation& simulation) {
  double most = 0;
  for (const Vec3d& v : simulation.velocities()) most = std::max(most, length(v));
  return most;
}

/// In substeps as reference::Simulation takes them, but of a strip that starts draped.
CapstanWatch seen_by_vbd(const Capstan& capstan) {
  constexpr std::uint32_t kSweeps = 100;  // they carry the pull from end to end
  constexpr int kSubsteps = 8;
  const scene::Scene scene = capstan.scene();
  Sheet strip(scene);
  reference::MassSpringSystem& now = strip.system;
  reference::VbdStepper stepper(strip.model, kSweeps);
  const StripOverCapsule begun = capstan.strip();
  for (Vec3d& x : now.position) x = begun.draped(x);
  const Assets assets = capstan.assets(scene);
  const double dt = 1.0 / 60 / kSubsteps;
  reference::Proximity contact(scene, strip.model, assets.objects, assets.deformations, dt,
                               {.own_pairs = true});
  CapstanWatch watch(capstan, now);
  for (int step = 0; step < kSubsteps * static_cast<int>(capstan.frames); ++step) {
    const std::vector<Vec3d> before = now.position, velocity_before = now.velocity;
    stepper.advance({now, before, dt, 1, [&](std::span<const Vec3d> velocity) -> reference::Pressed {
                       return {{}, contact.presses(before, velocity, step * dt, dt)};
                     }});
    const std::vector<Vec3d> position = now.position, velocity = now.velocity;
    contact.answer({before, velocity_before, now.inverse_mass, now.position, now.velocity, stepper.held()},
                   step * dt, dt);
    for (std::size_t node = 0; node < position.size(); ++node)
      if (now.position[node] != position[node] || now.velocity[node] != velocity[node]) stepper.forget(node);
    if (step % kSubsteps == kSubsteps - 1) watch.see(now.position, now.velocity);
  }
  return watch;
}

}  // namespace

TEST_CASE(
    "long: in double, by vbd a block on a plane sinks in as much as its weight says, whatever the steps") {
  for (const double young : {6e4, 1e6}) {
    double least = 2, most = 0;
    for (const Steps& steps : {Steps{2, 10}, Steps{8, 2}, Steps{8, 10}, Steps{32, 2}}) {
      auto made = simulation_of_text(block_on_plane(steps, young, 0, 0, 0.4));
      advance(made, 60);
      double top = 0, low = 1;
      for (const Vec3d& x : made.positions()) {
        top = std::max(top, x.y);
        low = std::min(low, x.y);
      }
      const double sunk = (0.2 + kThickness - top) / (1000 * kGravity * 0.2 * 0.2 / (2 * young));
      MESSAGE(steps.substeps << " substeps of " << steps.sweeps << " sweeps, E " << young << ": " << sunk
                             << " of the law, " << fastest(made) << " m/s");
      least = std::min(least, sunk);
      most = std::max(most, sunk);
      CHECK(std::abs(low - kThickness) < 1e-3 * kThickness);
      CHECK(fastest(made) < 1e-4);
    }
    // A column of three cells sinks by 36/37 of what a bar does.
    CHECK(least > 0.96);
    CHECK(most < 0.98);
  }
}

TEST_CASE("in double, by vbd a block slides down a plane as Coulomb says, or lies") {
  for (const Steps& steps : {Steps{8, 10}, Steps{32, 10}})
    for (const double friction : {0.3, 0.535, 0.557, 0.8}) {  // the slope's tangent is 0.546
      auto made = simulation_of_text(block_on_plane(steps, 6e4, 0.4, 0.5, friction, "neo_hookean"));
      const auto speed = [&] {
        double sum = 0;
        for (const Vec3d& v : made.velocities()) sum += v.x;
        return sum / static_cast<double>(made.velocities().size());
      };
      advance(made, 150);  // it swings first
      const double before = speed();
      const std::vector<Vec3d> first = made.positions();
      advance(made, 30);
      const double gained = speed() - before,
                   law = std::max(0.0, kGravity * (std::sin(0.5) - friction * std::cos(0.5)) * 0.5);
      double crept = 0;
      for (std::size_t n = 0; n < first.size(); ++n)
        if (first[n].y < 1.02 * kThickness)
          crept = std::max(crept, std::abs(made.positions()[n].x - first[n].x));
      MESSAGE(steps.substeps << " substeps, friction " << friction << ": " << gained << " m/s, by Coulomb "
                             << law << "; its feet went " << crept << " m");
      CHECK(std::abs(gained - law) < 0.01 * kGravity * std::cos(0.5) * 0.5 * friction);
      if (law == 0) CHECK(crept < 1e-9);
    }
}

TEST_CASE("in double, by vbd a stiff sheet slides down a plane as Coulomb says, by one sweep too") {
  for (const Steps& steps : {Steps{2, 10}, Steps{8, 1}, Steps{32, 1}})
    for (const double friction : {0.1, 0.4}) {  // the slope's tangent is 0.546
      auto made = simulation_of_text(
          R"("gravity": [)" + text(kGravity * std::sin(0.5)) + ", " + text(-kGravity * std::cos(0.5)) +
          R"(, 0], "time": {"substeps": )" + std::to_string(steps.substeps) +
          R"(}, "solver": {"kind": "vbd", "iterations": )" + std::to_string(steps.sweeps) +
          R"(}, "contact": {"thickness": 0.005, "self": false}, "cloths": [{"grid": [12, 10], "size": [0.4, 0.3],
              "plane": "xz", "density": 0.3, "friction": )" +
          text(friction) + R"(, "stiffness": {"structural": 3000, "shear": 800, "bend": 5}, "damping": 0.01,
              "transform": {"translate": [0, 0.005, 0]}}],
            "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
      const std::vector<Vec3d> first = made.positions();
      advance(made, 30);
      const double time = 0.5, step = 1.0 / 60 / steps.substeps,
                   pull = kGravity * (std::sin(0.5) - friction * std::cos(0.5)),
                   law = 0.5 * pull * time * (time + step);  // of backward Euler from rest
      double least = 1e9, most = 0;
      for (std::size_t n = 0; n < first.size(); ++n) {
        const double way = made.positions()[n].x - first[n].x;
        least = std::min(least, way / law);
        most = std::max(most, way / law);
      }
      MESSAGE(steps.substeps << " substeps of " << steps.sweeps << " sweeps, friction " << friction << ": "
                             << least << " to " << most << " of the law");
      CHECK(least > 0.995);
      CHECK(most < 1.005);
    }
}

TEST_CASE(
    "long: in double, by vbd a block past the rim of a box topples as a rigid one, and before it stands") {
  // A rigid cube that turns over a rim so far from below its middle, from rest: where the middle is after `time`.
  const auto dropped = [](double past, double time) {
    constexpr double kHalf = 0.1, kStep = 1e-4;
    double angle = 0, rate = 0;
    for (double t = 0; t < time; t += kStep) {
      rate += kStep * kGravity * (past * std::cos(angle) + kHalf * std::sin(angle)) /
              (2.0 / 3 * kHalf * kHalf + kHalf * kHalf + past * past);
      angle += kStep * rate;
    }
    return kHalf - kHalf * std::cos(angle) + past * std::sin(angle);
  };
  for (const double rim : {-0.03, 0.03}) {  // from below the middle, which nodes at 0.033 m are beside
    auto made = simulation_of_text(
        R"("time": {"substeps": 32}, "solver": {"kind": "vbd", "iterations": 10}, "contact": {"thickness": )" +
        text(kThickness) +
        R"(}, "bodies": [{"block": [3, 3, 3], "size": [0.2, 0.2, 0.2], "density": 1000, "friction": 0.8,
            "material": {"young": 1e6, "poisson": 0.3, "energy": "corotated", "damping": 0.002},
            "transform": {"translate": [0, 0.105, 0]}}],
            "colliders": [{"kind": "box", "center": [)" +
        text(rim - 0.2) + R"(, -0.1, 0], "size": [0.4, 0.2, 0.6]}])");
    const auto height = [&] {
      double sum = 0;
      for (const Vec3d& x : made.positions()) sum += x.y;
      return sum / static_cast<double>(made.positions().size());
    };
    const double first = height();
    const int frames = rim < 0 ? 15 : 60;
    advance(made, frames);
    const double law = rim < 0 ? dropped(-rim, frames / 60.0) : 0;
    MESSAGE("rim at " << rim << " m: its middle is lower by " << first - height() << " m, of a rigid one by "
                      << law);
    CHECK(std::abs(first - height() - law) < std::max(0.25 * law, 0.2 * kThickness));
  }
}

TEST_CASE("in double, by vbd a block slides along a groove by the friction of both its sides") {
  // Planes at 45 degrees bear 1/sqrt(2) of the weight each: friction is that of a plane times sqrt(2).
  for (const double slope : {0.5, 0.42, 0.38}) {
    constexpr double kFriction = 0.3;
    auto made = simulation_of_text(
        R"("gravity": [0, )" + text(-kGravity * std::cos(slope)) + ", " + text(kGravity * std::sin(slope)) +
        R"(], "time": {"substeps": 8}, "solver": {"kind": "vbd", "iterations": 10}, "contact": {"thickness": )" +
        text(kThickness) +
        R"(}, "bodies": [{"block": [3, 3, 3], "size": [0.2, 0.2, 0.2], "density": 1000, "friction": )" +
        text(kFriction) +
        R"(, "material": {"young": 3e5, "poisson": 0.3, "energy": "corotated", "damping": 0.002},
            "transform": {"rotate": [0, 0, 0.3826834, 0.9238795], "translate": [0, )" +
        text(std::sqrt(2) * (0.1 + kThickness)) + R"(, 0]}}], "colliders": [
            {"kind": "plane", "point": [0, 0, 0], "normal": [1, 1, 0]},
            {"kind": "plane", "point": [0, 0, 0], "normal": [-1, 1, 0]}])");
    const auto speed = [&] {
      double sum = 0;
      for (const Vec3d& v : made.velocities()) sum += v.z;
      return sum / static_cast<double>(made.velocities().size());
    };
    advance(made, 20);  // it settles first
    const double before = speed();
    advance(made, 30);
    const double gained = (speed() - before) / 0.5,
                 law =
                     std::max(0.0, kGravity * (std::sin(slope) - std::sqrt(2) * kFriction * std::cos(slope)));
    MESSAGE("slope " << slope << ": " << gained << " m/s², law " << law);
    CHECK(std::abs(gained - law) < 0.01 * kGravity * std::sqrt(2) * kFriction * std::cos(slope));
  }
}

TEST_CASE("in double, by vbd a block that falls on a plane does not come back as high as it was") {
  for (const Steps& steps : {Steps{2, 10}, Steps{8, 2}, Steps{8, 10}, Steps{32, 10}})
    for (const double young : {6e4, 1e7}) {
      auto made = simulation_of_text(block_on_plane(steps, young, 0.4, 0, 0.4, "neo_hookean", 0.3));
      double above = 0;
      for (int frame = 0; frame < 60; ++frame) {
        advance(made, 1);
        double height = 0;
        for (const Vec3d& x : made.positions()) height += x.y / static_cast<double>(made.positions().size());
        if (frame > 12) above = std::max(above, height - 0.1 - kThickness);  // it lands after 12.1
      }
      MESSAGE(steps.substeps << " substeps of " << steps.sweeps << " sweeps, E " << young
                             << ": it comes back to " << above << " of 0.2 m");
      CHECK(above < 0.2);
    }
}

TEST_CASE("in double, by vbd a strip over a capsule rests where friction holds it and slides where not") {
  for (const double right : {0.3, 0.72}) {
    const CapstanWatch seen = seen_by_vbd(Capstan{0.3, right, 0.3});
    MESSAGE("0.3 m and " << right << " m: " << 1e3 * seen.drift() << " mm/s, longest edge " << seen.stretch);
    CHECK(seen.drift() < 3e-4);
    CHECK(seen.rise < 0.01);
  }
  const CapstanWatch slid = seen_by_vbd(Capstan{0.3, 1, 0.3});
  MESSAGE("0.3 m and 1 m: " << slid.way(40) << " m in two thirds of a second");
  CHECK(slid.way(40) > 0.1);
  CHECK(slid.rise < 0.01);
}
