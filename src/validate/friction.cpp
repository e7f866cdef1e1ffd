// Cloth on obstacles: Coulomb's law on a plane, Euler's and Eytelwein's on a rail.
#include <cmath>

#include "closed_forms/strip_over_capsule.hpp"
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

struct Rail {
  std::uint32_t touching;          // so many edges
  double hangs_left, hangs_right;  // about [m]
  double radius = 0.05, friction = 0.3;
};

/// A strip over a round rail.
struct OnRail {
  Trial trial;
  RopeOverCapsule rope;  // where the strip was looked at last
  double speed = 0;      // then, along the strip, of all mass [m/s]

  static Result<OnRail> create(const Rig& rig, const Rail& rail) {
    constexpr double kThickness = 0.002, kPull = 1000;  // [m], [N/m]
    // Nodes lie on the rail, and the middles of edges nearer to its axis.
    const double middle = (rail.radius + kThickness) * std::cos(0.5 * std::acos(-1.0) / rail.touching);
    const StripOverCapsule strip({rail.hangs_left, rail.hangs_right, middle, rail.friction, kGravity},
                                 rail.touching, kDensity / kPull);
    WEFT_TRY(trial, Trial::create(rig, R"("contact": {"thickness": )" + text_of(kThickness) +
                                           R"(}, "cloths": [{)" + grid_of(strip.rows(), 3, strip.cell()) +
                                           R"(, "plane": "xz", "friction": )" + text_of(rail.friction) +
                                           ", " + members_of(rig, {.modulus = kPull, .shear = 100}) +
                                           R"(}], "colliders": [{"kind": "capsule", "a": [0, 0, -0.2],
                                    "b": [0, 0, 0.2], "radius": )" +
                                           text_of(rail.radius) + "}]"));
    WEFT_CHECK(trial.change([&](std::size_t, Vec3d& x, Vec3d&) { x = strip.draped(x); }));
    OnRail made{std::move(trial), strip.rope()};
    WEFT_CHECK(made.look());
    return made;
  }
  Result<void> look() {
    WEFT_TRY(now, trial.now());
    rope.left = -now.position.front().y;
    rope.right = -now.position.back().y;
    speed = -now.angular_momentum({}).z / (rope.radius * now.total_mass());
    return {};
  }
};

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
  WEFT_TRY(held, OnRail::create(rig, {16, 0.2, 0.5}));  // friction holds up to 0.59 m
  const double start = held.rope.right;
  WEFT_CHECK(held.trial.advance(24));
  WEFT_CHECK(held.look());
  std::vector<Measure> measures{
      {"rope over a rail, 0.2 m and 0.5 m: way in 0.4 s", "m", held.rope.right - start, 0, 0.002}};
  // An error at the start, by a first substep or by what still rings, grows as the way does: so the rope starts at
  // 0.1 s, where and as fast as the strip is. From 0.35 s on it would leave the rail on its way up.
  constexpr std::uint32_t kFrom = 6, kFrames = 12;
  for (const Rail& rail :
       {Rail{16, 0.2, 0.9}, Rail{32, 0.2, 0.9}, Rail{32, 0.3, 1.2, 0.1}, Rail{16, 0.3, 0.6, 0.05, 0.1}}) {
    WEFT_TRY(strip, OnRail::create(rig, rail));
    WEFT_CHECK(strip.trial.advance(kFrom));
    WEFT_CHECK(strip.look());
    const RopeOverCapsule rope = strip.rope;
    const double speed = strip.speed;
    WEFT_CHECK(strip.trial.advance(kFrames));
    WEFT_CHECK(strip.look());
    const double way = 0.5 * (rope.left - strip.rope.left + strip.rope.right - rope.right);
    measures.push_back({"rope over a rail of " + text_of(rail.radius) + " m, " +
                            std::to_string(rail.touching) + " edges on it, µ = " + text_of(rail.friction) +
                            ": way in 0.2 s",
                        "m", way, rope.way(kFrames * kFrame, speed), 0.02});
  }
  return measures;
}

}  // namespace weft::validate
