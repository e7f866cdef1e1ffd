// Strips clamped at one end: the elastica.
#include <cmath>

#include "closed_forms/elastica.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "validate/laws.hpp"
#include "validate/trial.hpp"

namespace weft::validate {
namespace {

constexpr double kClamped = 0.24, kModulus = 300;  // length of a strip [m], [N/m]

/// The middle of the free end, from the clamp by the length, of a strip along x in units of that: under a weight of
/// w L³/B = `load` at an angle `tilt` from -x towards -z [rad].
Result<Vec3d> bent_tip(const Rig& rig, Pattern pattern, double load, double tilt, double drag,
                       std::uint32_t frames) {
  const PatternSheet sheet = pattern_sheet(pattern, kClamped, 24, 3, 1);
  const double weight = kDensity * kGravity;
  WEFT_TRY(trial, Trial::create(rig,
                                R"("contact": {"method": "none"}, "drag": )" + text_of(drag) +
                                    R"(, "gravity": [)" + text_of(-kGravity * std::cos(tilt)) + ", 0, " +
                                    text_of(-kGravity * std::sin(tilt)) + R"(], "cloths": [{)" + kMesh +
                                    R"(, "density": 0.2, "fabric": {"warp": 300, "shear": 100,
                             "bending_warp": )" +
                                    text_of(weight * kClamped * kClamped * kClamped / load) +
                                    R"(}, "pins": [{"box": {"min": [-1, -1, -1], "max": [1e-6, 1, 1]}}]}])",
                                sheet.triangle_mesh()));
  WEFT_CHECK(trial.advance(frames));
  WEFT_TRY(end, trial.now());
  Vec3d tip;
  double count = 0;
  for (std::size_t n = 0; n < sheet.position.size(); ++n)
    if (sheet.position[n].x > kClamped - 1e-6) {
      tip += end.position[n];
      ++count;
    }
  return tip / (count * kClamped);
}

double softness() { return kDensity * kGravity * kClamped / kModulus; }

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
    WEFT_TRY(tip, bent_tip(rig, one.pattern, one.load, std::acos(0.0), 12, 100));  // e⁻¹⁰
    measures.push_back({"strip of w L³/B = " + text_of(one.load) + ", " + name_of(one.pattern) +
                            " triangles: drop by the length",
                        "", -tip.z, Elastica(one.load, softness()).drop, 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_standing(const Rig& rig) {
  constexpr double kTilt = 0.05;
  std::vector<Measure> measures;
  for (const double load : {6.0, 12.0}) {
    WEFT_TRY(tip, bent_tip(rig, Pattern::Irregular, load, kTilt, 8, 150));
    const Vec3d down{-std::cos(kTilt), 0, -std::sin(kTilt)}, level{std::sin(kTilt), 0, -std::cos(kTilt)};
    const Elastica exact(load, softness(), std::acos(0.0) - kTilt);
    const std::string what = "standing strip of w L³/B = " + text_of(load);
    measures.push_back({what + ": tip aside by the length", "", dot(tip, level), exact.reach, 0.02});
    measures.push_back({what + ": tip's height by the length", "", -dot(tip, down), -exact.drop, 0.02});
  }
  return measures;
}

}  // namespace weft::validate
