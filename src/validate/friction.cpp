// Cloth on obstacles: Coulomb's law on a plane, Euler's and Eytelwein's on a rail.
#include <cmath>

#include "closed_forms/rope_over_capsule.hpp"
#include "validate/laws.hpp"
#include "validate/trial.hpp"

namespace weft::validate {
namespace {

/// A plane and a sheet of 14 x 11 nodes that lies on it, `above` more than the thickness [m].
std::string on_plane(const Rig& rig, const Vec3d& pull, double friction, double above) {
  return R"("gravity": [)" + text_of(pull.x) + ", " + text_of(pull.y) +
         R"(, 0], "contact": {"thickness": 0.005},
      "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "friction": )" +
         text_of(friction) + R"(}], "cloths": [{)" + grid_of(14, 11, 0.02) +
         R"(, "plane": "xz", "friction": )" + text_of(friction) + R"(, "transform": {"translate": [0, )" +
         text_of(0.005 + above) + ", 0]}, " +
         members_of(rig, {.modulus = 300, .bending = 1e-4, .shear = 30}) + "}]";
}

}  // namespace

Result<std::vector<Measure>> measure_slope(const Rig& rig) {
  constexpr double kFriction = 0.4;
  std::vector<Measure> measures;
  for (const double part : {0.9, 1.1, 1.5}) {
    const double angle = std::atan(part * kFriction);
    const Vec3d pull = kGravity * Vec3d{std::sin(angle), -std::cos(angle), 0};
    WEFT_TRY(trial, Trial::create(rig, on_plane(rig, pull, kFriction, 0)));
    WEFT_CHECK(trial.advance(12));
    WEFT_TRY(before, trial.now());
    WEFT_CHECK(trial.advance(12));
    WEFT_TRY(end, trial.now());
    const std::string what = "sheet on a slope of " + text_of(part) + " µ";
    if (part < 1)
      measures.push_back({what + ": speed", "m/s", length(end.mean_velocity()), 0, 1e-3});
    else
      measures.push_back({what + ": acceleration", "m/s²",
                          (end.mean_velocity().x - before.mean_velocity().x) / (12 * kFrame),
                          kGravity * (std::sin(angle) - kFriction * std::cos(angle)), 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_landing(const Rig& rig) {
  constexpr double kFriction = 0.3, kSpeed = 2;
  constexpr std::uint32_t kFrames = 24;
  std::vector<Measure> measures;
  for (const double height : {0.05, 0.2}) {
    WEFT_TRY(trial, Trial::create(rig, on_plane(rig, {0, -kGravity, 0}, kFriction, height)));
    WEFT_CHECK(trial.change([&](std::size_t, Vec3d&, Vec3d& v) { v.x = kSpeed; }));
    WEFT_CHECK(trial.advance(kFrames));
    WEFT_TRY(end, trial.now());
    // Whatever the blow was, the floor's forces have taken all that gravity gave and what is left of the fall.
    const double pressed = kGravity * kFrames * kFrame + end.mean_velocity().y;
    measures.push_back({"sheet that falls by " + text_of(height) + " m and slides: friction by what presses",
                        "", (kSpeed - end.mean_velocity().x) / pressed, kFriction, 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_capstan(const Rig& rig) {
  constexpr double kRadius = 0.05, kThickness = 0.002, kCell = 0.01, kLeft = 0.2, kFriction = 0.3;
  constexpr std::uint32_t kFrames = 24;
  const double arc = std::acos(-1.0) * (kRadius + kThickness);
  std::vector<Measure> measures;
  for (const double right : {0.5, 0.9}) {  // friction holds up to 0.59 m
    const RopeOverCapsule rope{kLeft, right, kRadius + kThickness, kFriction, kGravity};
    const auto rows = static_cast<std::uint32_t>(std::lround((kLeft + arc + right) / kCell)) + 1;
    WEFT_TRY(
        trial,
        Trial::create(rig, R"("contact": {"thickness": )" + text_of(kThickness) + R"(}, "cloths": [{)" +
                               grid_of(rows, 3, kCell) + R"(, "plane": "xz", "friction": )" +
                               text_of(kFriction) + ", " + members_of(rig, {.modulus = 1000, .shear = 100}) +
                               R"(}], "colliders": [{"kind": "capsule", "a": [0, 0, -0.2], "b": [0, 0, 0.2],
                                              "radius": )" +
                               text_of(kRadius) + "}]"));
    WEFT_CHECK(trial.change([&](std::size_t, Vec3d& x, Vec3d&) {  // draped, at the thickness
      const double along = x.x + 0.5 * kCell * (rows - 1) - kLeft, angle = along / rope.radius;
      if (along < 0)
        x = {-rope.radius, along, x.z};
      else if (along > arc)
        x = {rope.radius, arc - along, x.z};
      else
        x = {-rope.radius * std::cos(angle), rope.radius * std::sin(angle), x.z};
    }));
    WEFT_TRY(start, trial.now());
    WEFT_CHECK(trial.advance(kFrames));
    WEFT_TRY(end, trial.now());
    const double way = start.position.back().y - end.position.back().y;
    measures.push_back({"rope over a rail, 0.2 m and " + text_of(right) + " m: way in 0.4 s", "m", way,
                        rope.way(kFrames * kFrame), right < 0.59 ? 0.002 : 0.02});
  }
  return measures;
}

}  // namespace weft::validate
