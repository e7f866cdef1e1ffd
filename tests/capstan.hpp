// A strip that hangs over a horizontal capsule: what friction holds does not creep, what it does not hold slides, and
// the hold gives no energy.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "closed_forms/rope_over_capsule.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "scene/load.hpp"

namespace weft {

/// Five nodes wide, 10 mm apart. The capsule's axis is z.
struct Capstan {
  double left, right, friction;  // what hangs free [m], [m], 1

  static constexpr double kRadius = 0.05, kThickness = 0.002, kSpacing = 0.01,
                          kDistance = kRadius + kThickness, kGravity = 9.81;
  static constexpr std::uint32_t kWidth = 5;

  double arc() const { return std::acos(-1.0) * kDistance; }  // of the strip on the capsule [m]
  std::uint32_t rows() const {
    return static_cast<std::uint32_t>(std::lround((left + arc() + right) / kSpacing)) + 1;
  }
  scene::Scene scene() const {
    const auto text = [](double value) { return std::to_string(value); };
    auto made = scene::parse_scene(
        R"({"format": "weft-scene/1", "solver": {"kind": "multigrid"}, "time": {"substeps": 6},
        "contact": {"method": "proximity", "thickness": )" +
            text(kThickness) + R"(}, "cloths": [{"grid": [)" + text(rows()) + ", " + text(kWidth) +
            R"(], "size": [)" + text(kSpacing * (rows() - 1)) + ", " + text(kSpacing * (kWidth - 1)) +
            R"(], "plane": "xz", "density": 0.2, "damping": 0.01, "friction": )" + text(friction) +
            R"(, "stiffness": {"structural": 1000, "shear": 300, "bend": 1}}],
        "colliders": [{"kind": "capsule", "a": [0, 0, -0.2], "b": [0, 0, 0.2], "radius": )" +
            text(kRadius) + "}]}",
        "capstan.json");
    REQUIRE_MESSAGE(made, made.error().message);
    return std::move(*made);
  }
  RopeOverCapsule rope() const { return {left, right, kDistance, friction, kGravity}; }
  /// Where a node starts that the scene has at `flat`: draped, at the thickness and its rest length.
  Vec3d draped(const Vec3d& flat) const {
    const double along = flat.x + 0.5 * kSpacing * (rows() - 1) - left, angle = along / kDistance;
    if (along < 0) return {-kDistance, along, flat.z};
    if (along > arc()) return {kDistance, arc() - along, flat.z};
    return {-kDistance * std::cos(angle), kDistance * std::sin(angle), flat.z};
  }
};

/// Watches a strip of these masses and springs from 0.1 s on, frame by frame for a second.
class CapstanWatch {
 public:
  explicit CapstanWatch(reference::MassSpringSystem strip) : strip_(std::move(strip)) {}
  void see(const std::vector<Vec3d>& position, const std::vector<Vec3d>& velocity) {
    strip_.position = position;
    strip_.velocity = velocity;
    ends_.push_back(position.back().y);
    if (++frames_ < 6) return;
    for (const reference::SpringLink& s : strip_.springs)
      stretch = std::max(stretch, length(position[s.node_a] - position[s.node_b]) / s.rest_length);
    const double energy = reference::energy(strip_);
    least_ = std::min(least_, energy);
    rise = std::max(rise, (energy - least_) / (mass() * 9.81 * Capstan::kRadius));
  }
  /// Of the end of the strip in the second half second [m/s].
  double drift() const { return 2 * std::abs(ends_[59] - ends_[29]); }
  /// How far it has gone down after so many frames [m].
  double way(std::size_t frames) const { return ends_[0] - ends_[frames - 1]; }

  double stretch = 0;  // of the longest edge, 1
  double rise = 0;     // the most by which the energy has risen since it was least, in m g r

 private:
  double mass() const {
    double sum = 0;
    for (const double inverse : strip_.inverse_mass) sum += 1 / inverse;
    return sum;
  }
  reference::MassSpringSystem strip_;
  int frames_ = 0;
  double least_ = 1e9;
  std::vector<double> ends_;  // the height of the strip's right end after each frame [m]
};

/// `run(capstan)` takes a strip through a second and returns what a watch has seen. Friction of 0.3 holds 0.3 m and
/// L' = e^(μπ) L + 2 μ R (1 + e^(μπ)) / (1 + μ²) = 0.87 m, with the strip's own weight on the capsule.
template <class Run>
void check_capstan(const Run& run, std::initializer_list<double> held = {0.3, 0.5, 0.72, 0.85}) {
  for (const double right : held) {
    const CapstanWatch seen = run(Capstan{0.3, right, 0.3});
    MESSAGE("0.3 m and ", right, " m: ", 1e3 * seen.drift(), " mm/s, longest edge ", seen.stretch);
    CHECK(seen.drift() < 3e-4);
    if (right < 0.8) CHECK(seen.stretch < 1.003);  // then it has not slid first
    CHECK(seen.rise < 0.01);
  }
  const Capstan beyond{0.3, 1, 0.3};
  const CapstanWatch slid = run(beyond);
  const double exact = beyond.rope().way(40.0 / 60);
  MESSAGE("0.3 m and 1 m: ", slid.way(40), " m in two thirds of a second, a rope ", exact, " m");
  CHECK(slid.way(40) > 0.5 * exact);
  CHECK(slid.way(40) < 1.1 * exact);
  CHECK(slid.rise < 0.01);
  const CapstanWatch stuck = run(Capstan{0.3, 0.5, 10});
  MESSAGE("energy rises by ", stuck.rise, " m g r");
  CHECK(stuck.rise < 0.01);
}

}  // namespace weft
