// A strip that hangs over a horizontal capsule, or a mesh like one: what friction holds does not creep, what it does
// not hold slides, and the hold gives no energy.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "closed_forms/strip_over_capsule.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "model/assets.hpp"
#include "scene/load.hpp"

namespace weft {

/// Five nodes wide. The capsule's axis is z.
struct Capstan {
  double left, right, friction;  // what hangs free, about [m], [m]; 1
  double radius = 0.05;          // [m]
  std::uint32_t touching = 16;   // so many edges
  std::uint32_t frames = 60;     // for which it is watched
  double shear = 300;            // [N/m]
  std::uint32_t substeps = 6;    // of the kernels
  std::uint32_t facets = 0;      // of a tube of triangles in its place; 0: a capsule

  static constexpr double kThickness = 0.002, kGravity = 9.81;
  static constexpr double kDensity = 0.2, kModulus = 1200;  // [kg/m²]; of the springs below, about [N/m]
  static constexpr std::uint32_t kWidth = 5;

  /// Nodes lie on a capsule, edges on a tube.
  StripOverCapsule strip() const {
    const double middle = facets > 0 ? 1 : std::cos(0.5 * std::numbers::pi / touching);  // of an edge
    return {{left, right, middle * (radius + kThickness), friction, kGravity}, touching, kDensity / kModulus};
  }
  scene::Scene scene() const {
    const StripOverCapsule begun = strip();
    const auto text = [](double value) {
      std::ostringstream out;
      out.precision(12);
      out << value;
      return out.str();
    };
    auto made = scene::parse_scene(
        R"({"format": "weft-scene/1", "solver": {"kind": "multigrid"}, "time": {"substeps": )" +
            text(substeps) + R"(},
        "contact": {"method": "proximity", "thickness": )" +
            text(kThickness) + R"(}, "cloths": [{"grid": [)" + text(begun.rows()) + ", " + text(kWidth) +
            R"(], "size": [)" + text(begun.cell() * (begun.rows() - 1)) + ", " +
            text(begun.cell() * (kWidth - 1)) +
            R"(], "plane": "xz", "density": 0.2, "damping": 0.01, "friction": )" + text(friction) +
            R"(, "stiffness": {"structural": 1000, "shear": )" + text(shear) + R"(, "bend": 1}}],
        "colliders": [)" +
            (facets > 0 ? R"({"kind": "mesh", "mesh": "tube.obj"})"
                        : R"({"kind": "capsule", "a": [0, 0, -0.2], "b": [0, 0, 0.2], "radius": )" +
                              text(radius) + "}") +
            "]}",
        "capstan.json");
    if (!made) FAIL(made.error().message);
    return std::move(*made);
  }
  Assets assets(const scene::Scene& of) const {
    auto made = load_assets(of, [&](const std::string&) -> Result<mesh::TriangleMesh> { return tube(); });
    if (!made) FAIL(made.error().message);
    return std::move(*made);
  }

 private:
  /// Open at its ends, with as much length around itself as the capsule has.
  mesh::TriangleMesh tube() const {
    constexpr std::uint32_t kRings = 10;
    const double angle = 2 * std::numbers::pi / facets, reach = radius * 0.5 * angle / std::sin(0.5 * angle);
    mesh::TriangleMesh made;
    for (std::uint32_t j = 0; j <= kRings; ++j)
      for (std::uint32_t i = 0; i < facets; ++i)
        made.positions.push_back(Vec3d{reach * std::cos(angle * (i + 0.3)),
                                       reach * std::sin(angle * (i + 0.3)), 0.4 * j / kRings - 0.2}
                                     .to<float>());
    for (std::uint32_t j = 0; j < kRings; ++j)
      for (std::uint32_t i = 0; i < facets; ++i) {
        const std::uint32_t a = j * facets + i, b = j * facets + (i + 1) % facets;
        made.triangles.push_back({a, b, b + facets});
        made.triangles.push_back({a, b + facets, a + facets});
      }
    return made;
  }
};

/// Watches a strip of these masses and springs from 0.1 s on, frame by frame for a second.
class CapstanWatch {
 public:
  CapstanWatch(const Capstan& capstan, reference::MassSpringSystem strip)
      : distance_(capstan.radius + Capstan::kThickness), strip_(std::move(strip)) {}
  void see(const std::vector<Vec3d>& position, const std::vector<Vec3d>& velocity) {
    strip_.position = position;
    strip_.velocity = velocity;
    ends_.push_back(position.back().y);
    double moment = 0;
    for (std::size_t node = 0; node < position.size(); ++node)
      moment -= cross(position[node], velocity[node]).z / strip_.inverse_mass[node];
    hangs_.push_back({-position.front().y, -position.back().y, moment / (distance_ * mass())});
    if (++frames_ < 6) return;
    for (const reference::SpringLink& s : strip_.springs)
      stretch = std::max(stretch, length(position[s.node_a] - position[s.node_b]) / s.rest_length);
    const double energy = reference::energy(strip_);
    least_ = std::min(least_, energy);
    rise = std::max(rise, (energy - least_) / (mass() * 9.81 * distance_));
  }
  /// Of the end of the strip in the second half second [m/s].
  double drift() const { return 2 * std::abs(ends_[59] - ends_[29]); }
  /// How far it has gone down after so many frames [m].
  double way(std::size_t frames) const { return ends_[0] - ends_[frames - 1]; }
  /// What hangs free after so many frames, and how fast the strip goes along itself, by its moment of momentum.
  struct Hang {
    double left, right, speed;  // [m], [m], [m/s]
  };
  const Hang& hang(std::size_t frames) const { return hangs_[frames - 1]; }

  double stretch = 0;  // of the longest edge, 1
  double rise = 0;     // the most by which the energy has risen since it was least, in m g r

 private:
  double mass() const {
    double sum = 0;
    for (const double inverse : strip_.inverse_mass) sum += 1 / inverse;
    return sum;
  }
  double distance_;
  reference::MassSpringSystem strip_;
  std::vector<Hang> hangs_;  // after each frame
  int frames_ = 0;
  double least_ = 1e9;
  std::vector<double> ends_;  // the height of the strip's right end after each frame [m]
};

/// `run(capstan)` takes a strip through a second and returns what a watch has seen. Friction of 0.3 holds 0.302 m, what
/// 0.3 m are in whole edges, and L' = e^(μπ) L + 2 μ R (1 + e^(μπ)) / (1 + μ²) = 0.876 m, with the strip's own weight
/// on the capsule. 0.86 m are 0.861 m, 0.983 of that, and 0.85 m 0.971.
template <class Run>
void check_capstan(const Run& run, std::initializer_list<double> held = {0.3, 0.5, 0.72, 0.86}) {
  for (const double right : held) {
    const CapstanWatch seen = run(Capstan{0.3, right, 0.3});
    MESSAGE("0.3 m and ", right, " m: ", 1e3 * seen.drift(), " mm/s, longest edge ", seen.stretch);
    CHECK(seen.drift() < 3e-4);
    if (right < 0.8) CHECK(seen.stretch < 1.003);  // then it has not slid first
    CHECK(seen.rise < 0.01);
  }
  const CapstanWatch slid = run(Capstan{0.3, 1, 0.3});
  MESSAGE("0.3 m and 1 m: ", slid.way(40), " m in two thirds of a second");
  CHECK(slid.way(40) > 0.1);
  CHECK(slid.rise < 0.01);
  const CapstanWatch stuck = run(Capstan{0.3, 0.5, 10});
  MESSAGE("energy rises by ", stuck.rise, " m g r");
  CHECK(stuck.rise < 0.01);
}

/// A strip slides as a rope does that starts where and as fast as it is by then, for 0.2 s in which that presses
/// everywhere: on cells of 20, 10 and 5 mm, on another rail, by other friction, and on tubes of triangles. The longer
/// ones ring for longer. Of the
/// finest the shear springs are soft: stiff ones that turn lag, and slow it by another 1 % in 8 substeps (in 16 not);
/// and so do the 6 of the kernels, in which it goes half an edge.
template <class Run>
void check_sliding(const Run& run) {
  struct Slide {
    Capstan capstan;
    std::uint32_t from = 6;  // frame
  };
  for (auto [capstan, from_frame] :
       {Slide{{0.2, 0.9, 0.3}}, Slide{{0.2, 0.9, 0.3, 0.05, 32, 60, 100, 8}},
        Slide{{0.2, 0.9, 0.3, 0.05, 8, 60, 300, 8}}, Slide{{0.3, 1.3, 0.3, 0.1, 32}, 12},
        Slide{{0.3, 0.6, 0.1}}, Slide{{.left = 0.2, .right = 0.9, .friction = 0.3, .facets = 64}},
        Slide{{.left = 0.2, .right = 0.9, .friction = 0.3, .touching = 8, .facets = 64}}}) {
    capstan.frames = from_frame + 12;
    const CapstanWatch seen = run(capstan);
    const auto &from = seen.hang(from_frame), &to = seen.hang(capstan.frames);
    const double way = 0.5 * (from.left - to.left + to.right - from.right);
    const StripOverCapsule strip = capstan.strip();
    RopeOverCapsule rope = strip.rope();
    rope.left = from.left, rope.right = from.right, rope.friction = strip.friction_of_chain();
    const double exact = rope.way(12.0 / 60, from.speed);
    MESSAGE("radius ", capstan.radius, " m, ", capstan.touching, " edges on it, ", capstan.facets,
            " facets, friction ", capstan.friction, ": ", way, " m, ", way / exact, " of a rope's way");
    CHECK(std::abs(way / exact - 1) < 0.02);
    CHECK(seen.rise < 0.01);
  }
}

}  // namespace weft
