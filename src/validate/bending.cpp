// Strips clamped at one end: the elastica, and Kirchhoff's rod where they twist too.
#include <array>
#include <cmath>

#include "closed_forms/elastica.hpp"
#include "closed_forms/kirchhoff_rod.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "validate/laws.hpp"
#include "validate/trial.hpp"

namespace weft::validate {
namespace {

constexpr double kClamped = 0.24;  // length of every strip [m]
const double kRightAngle = std::acos(0.0);

/// Clamped at x = 0, along x, its width along y.
struct Strip {
  Pattern pattern;
  int along = 24, across = 3;  // cells
  double modulus = 300;        // [N/m]
  double load = 10;            // w L³/B
  Vec3d down;                  // where its weight pulls

  double width() const { return pattern_sheet(pattern, kClamped, along, across).width; }
  double bending() const { return kDensity * kGravity * kClamped * kClamped * kClamped / load; }  // B [N·m]
};

/// The middle of the free end, from the clamp by the length, after as many frames with this drag.
Result<Vec3d> bent_tip(const Rig& rig, const Strip& strip, double drag, std::uint32_t frames) {
  const PatternSheet sheet = pattern_sheet(strip.pattern, kClamped, strip.along, strip.across, 1);
  const Vec3d gravity = kGravity * strip.down;
  WEFT_TRY(trial,
           Trial::create(rig,
                         R"("contact": {"method": "none"}, "drag": )" + text_of(drag) + R"(, "gravity": [)" +
                             text_of(gravity.x) + ", " + text_of(gravity.y) + ", " + text_of(gravity.z) +
                             R"(], "cloths": [{)" + kMesh + R"(, "density": 0.2, "fabric": {"warp": )" +
                             text_of(strip.modulus) + R"(, "shear": )" + text_of(strip.modulus / 3) +
                             R"(, "bending_warp": )" + text_of(strip.bending()) +
                             R"(}, "pins": [{"box": {"min": [-1, -1, -1], "max": [1e-6, 1, 1]}}]}])",
                         sheet.triangle_mesh()));
  WEFT_CHECK(trial.advance(frames));
  WEFT_TRY(end, trial.now());
  Vec3d tip;
  double count = 0;
  for (std::size_t n = 0; n < sheet.position.size(); ++n)
    if (sheet.position[n].x > kClamped - 1e-6) {
      tip += end.position[n] - Vec3d{0, sheet.width / 2, 0};
      ++count;
    }
  return tip / (count * kClamped);
}

constexpr double kInPlane = 70;  // of `narrow`

/// A strip on which Kirchhoff's rod can be tried: narrow, so that it twists freely; so stiff within its plane that it
/// hardly bends there, where even strain in a triangle resists too much; and not so stiff that it could not twist.
Strip narrow(double load, const Vec3d& down) {
  Strip strip{Pattern::Irregular, 48, 4, 0, load, down};
  strip.modulus = kInPlane * 12 * strip.bending() / (strip.width() * strip.width());
  return strip;
}

/// What a narrow strip has by Kirchhoff's rod, whose frame at the clamp is y, z, x.
Vec3d rod_tip(const Strip& strip) {
  const RodSection section{kInPlane, 2, strip.width() / (kClamped * std::sqrt(24.0))};  // D33 = B/2
  const Vec3d tip = KirchhoffRod(strip.load, {strip.down.y, strip.down.z, strip.down.x}, section).tip;
  return {tip.z, tip.x, tip.y};
}

double softness(const Strip& strip) { return kDensity * kGravity * kClamped / strip.modulus; }

}  // namespace

Result<std::vector<Measure>> measure_cantilever(const Rig& rig) {
  struct Case {
    Pattern pattern;
    double load;
  };
  std::vector<Measure> measures;
  for (const Case& one : {Case{Pattern::Irregular, 1},
                          {Pattern::Irregular, 10},
                          {Pattern::Irregular, 100},
                          {Pattern::OneDiagonal, 10},
                          {Pattern::Alternating, 10},
                          {Pattern::Equilateral, 10}}) {
    const Strip strip{.pattern = one.pattern, .load = one.load, .down = {0, 0, -1}};
    WEFT_TRY(tip, bent_tip(rig, strip, 12, 100));  // e⁻¹⁰
    measures.push_back({"strip of w L³/B = " + text_of(one.load) + ", " + name_of(one.pattern) +
                            " triangles: drop by the length",
                        "", -tip.z, Elastica(one.load, softness(strip)).drop, 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_refine(const Rig& rig) {
  std::vector<Measure> measures;
  for (const Pattern pattern : kPatterns) {
    std::array<double, 3> drop{};
    for (std::size_t level = 0; level < 3; ++level) {
      const Strip strip{.pattern = pattern, .along = 8 << level, .across = 1 << level, .down = {0, 0, -1}};
      WEFT_TRY(tip, bent_tip(rig, strip, 12, 100));
      drop[level] = -tip.z;
      measures.push_back({"strip of " + std::to_string(strip.along) + " cells, " + name_of(pattern) +
                              " triangles: drop by the length",
                          "", drop[level], Elastica(strip.load, softness(strip)).drop, 0.02});
    }
    measures.push_back({"strips of 8, 16 and 32 cells, " + name_of(pattern) + " triangles: order", "",
                        std::log2(std::abs((drop[0] - drop[1]) / (drop[1] - drop[2]))), 2, 0.15,
                        Bound::AtLeast});
  }
  return measures;
}

Result<std::vector<Measure>> measure_standing(const Rig& rig) {
  constexpr double kTilt = 0.05;
  std::vector<Measure> measures;
  for (const double load : {6.0, 12.0}) {
    const Vec3d down{-std::cos(kTilt), 0, -std::sin(kTilt)}, level{std::sin(kTilt), 0, -std::cos(kTilt)};
    const Strip strip{.pattern = Pattern::Irregular, .load = load, .down = down};
    WEFT_TRY(tip, bent_tip(rig, strip, 8, 150));
    const Elastica exact(load, softness(strip), kRightAngle - kTilt);
    const std::string what = "standing strip of w L³/B = " + text_of(load);
    measures.push_back({what + ": tip aside by the length", "", dot(tip, level), exact.reach, 0.02});
    measures.push_back({what + ": tip's height by the length", "", -dot(tip, down), -exact.drop, 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_twist(const Rig& rig) {
  const Strip strip = narrow(20, {0, -std::sqrt(0.5), -std::sqrt(0.5)});
  WEFT_TRY(tip, bent_tip(rig, strip, 12, 75));
  const Vec3d exact = rod_tip(strip);
  const std::string what = "strip aslant of w L³/B = 20: tip's ";
  return std::vector<Measure>{{what + "reach by the length", "", tip.x, exact.x, 0.02},
                              {what + "way along its width by the length", "", -tip.y, -exact.y, 0.02},
                              {what + "way across it by the length", "", -tip.z, -exact.z, 0.02}};
}

Result<std::vector<Measure>> measure_lateral(const Rig& rig) {
  constexpr double kTilt = 0.05;
  std::vector<Measure> measures;
  for (const double load : {12.0, 24.0}) {
    const Strip strip = narrow(load, {0, -std::cos(kTilt), -std::sin(kTilt)});
    WEFT_TRY(tip, bent_tip(rig, strip, 8, 100));
    const Vec3d exact = rod_tip(strip);
    const std::string what = "strip on edge of w L³/B = " + text_of(load) + ": tip";
    measures.push_back({what + " aside by the length", "", -tip.z, -exact.z, 0.02});
    measures.push_back({what + "'s reach by the length", "", tip.x, exact.x, 0.02});
  }
  return measures;
}

}  // namespace weft::validate
