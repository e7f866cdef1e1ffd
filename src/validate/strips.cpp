// Strips that hang by one end, and a rope by both.
#include <cmath>

#include "closed_forms/catenary.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "validate/laws.hpp"
#include "validate/trial.hpp"

namespace weft::validate {
namespace {

constexpr double kHung = 0.4;  // length of a strip that hangs by one end [m]
const std::string kAtRest = R"("drag": 12, "contact": {"method": "none"}, )";  // what swings is soon still

struct Moduli {
  double young = 0, poisson = 0;
};

/// Of a strip along x, pulled towards +x, from its lower 60 %: there the weight below a place pulls evenly across.
/// du/dx = w (L - x)/E and dv/dy = -ν w (L - x)/E, so u goes as w (L x - x²/2)/E.
Moduli moduli_of(const std::vector<Vec3d>& rest, const std::vector<Vec3d>& place) {
  std::vector<double> along, moved, across, narrowed;
  for (std::size_t n = 0; n < rest.size(); ++n) {
    const Vec3d& x = rest[n];
    if (x.x < 0.4 * kHung) continue;
    along.push_back(kDensity * kGravity * (kHung * x.x - x.x * x.x / 2));
    moved.push_back(place[n].x - x.x);
    across.push_back(kDensity * kGravity * (kHung - x.x) * x.y);
    narrowed.push_back(place[n].y - x.y);
  }
  const double softness = slope_of(along, moved);
  return {1 / softness, -slope_of(across, narrowed) / softness};
}

/// At rest, a strip whose cloth has these members beside its mesh.
Result<Moduli> hung(const Rig& rig, Pattern pattern, const std::string& members) {
  PatternSheet sheet = pattern_sheet(pattern, kHung, 24, 6);
  for (Vec3d& p : sheet.position) p.y -= sheet.width / 2;
  WEFT_TRY(trial, Trial::create(rig,
                                kAtRest + R"("gravity": [9.81, 0, 0], "cloths": [{)" + kMesh +
                                    R"(, "density": 0.2, )" + members +
                                    R"(, "pins": [{"box": {"min": [-1, -1, -1], "max": [1e-6, 1, 1]}}]}])",
                                sheet.triangle_mesh()));
  WEFT_CHECK(trial.advance(72));
  WEFT_TRY(end, trial.now());
  return moduli_of(trial.world().model().host.rest_position, end.position);
}

}  // namespace

Result<std::vector<Measure>> measure_stretch(const Rig& rig) {
  struct Strip {
    const char *what, *fabric;
    bool along_warp;
    double young, poisson;
    Pattern pattern = Pattern::Irregular;
    scene::FabricEnergy energy = scene::FabricEnergy::Yarn;
  };
  const std::string woven = R"("warp": 120, "weft": 60, "shear": 20, "poisson": 0.6)";
  const std::string green = woven + R"(, "energy": "green")";
  const std::string uneven = R"("warp": 2000, "weft": 20, "shear": 20, "poisson": 0.2)";
  const std::string solid = R"("warp": 50, "shear": 20, "poisson": 0.25, "energy": "neo_hookean")";
  std::vector<Measure> measures;
  for (const Strip& strip :
       {Strip{"along the weft", woven.c_str(), false, 60, 0.3},
        {"along the warp", woven.c_str(), true, 120, 0.6},
        {"along the weft, equilateral triangles", woven.c_str(), false, 60, 0.3, Pattern::Equilateral},
        {"by Green's strain", green.c_str(), false, 60, 0.3, Pattern::Irregular, scene::FabricEnergy::Green},
        {"neo-Hookean", solid.c_str(), true, 50, 0.25, Pattern::Irregular, scene::FabricEnergy::NeoHookean},
        {"E1 = 100 E2, along the warp", uneven.c_str(), true, 2000, 0.2},
        {"E1 = 100 E2, along the weft", uneven.c_str(), false, 20, 0.002}}) {
    if (!rig.takes(strip.energy)) continue;
    WEFT_TRY(found, hung(rig, strip.pattern,
                         std::string(R"("fabric": {)") + strip.fabric +
                             R"(, "bending_warp": 1e-5, "warp_direction": )" +
                             (strip.along_warp ? "[1, 0, 0]" : "[0, 1, 0]") + "}"));
    const std::string what = std::string("strip ") + strip.what;
    measures.push_back({what + ": modulus", "N/m", found.young, strip.young, 0.02});
    if (strip.poisson > 0.01)
      measures.push_back({what + ": Poisson's ratio", "", found.poisson, strip.poisson, 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_bias(const Rig& rig) {
  std::vector<Measure> measures;
  constexpr double kWarp = 300, kPoisson = 0.2, kShear = 20;
  for (const Pattern pattern : {Pattern::OneDiagonal, Pattern::Alternating, Pattern::Irregular}) {
    WEFT_TRY(found, hung(rig, pattern,
                         R"("fabric": {"warp": 300, "poisson": 0.2, "shear": 20, "bending_warp": 1e-5,
                     "warp_direction": [1, 1, 0]})"));
    measures.push_back({"strip cut at 45°, " + name_of(pattern) + " triangles: modulus", "N/m", found.young,
                        4 / (2 / kWarp - 2 * kPoisson / kWarp + 1 / kShear), 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_catenary(const Rig& rig) {
  std::vector<Measure> measures;
  for (const double nearer : {0.1, 0.3}) {
    WEFT_TRY(trial,
             Trial::create(rig, R"("drag": 8, "contact": {"method": "none"}, "cloths": [{)" +
                                    grid_of(41, 2, 0.02) + R"(, "plane": "xz", )" + members_of(rig, {2000}) +
                                    R"(, "pins": ["left"], "motions": [{"nodes": "right", "kind": "line",
                                         "direction": [-1, 0, 0], "speed": 0.4, "distance": )" +
                                    text_of(nearer) + "}]}]"));
    WEFT_CHECK(trial.advance(150));
    WEFT_TRY(end, trial.now());
    measures.push_back({"rope of 0.8 m, its ends nearer by " + text_of(nearer) + " m: sag", "m",
                        -end.position[20].y, catenary_sag(0.8, 0.8 - nearer), 0.02});
  }
  return measures;
}

}  // namespace weft::validate
