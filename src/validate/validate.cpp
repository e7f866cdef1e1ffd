#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "method/method.hpp"
#include "validate/laws.hpp"

namespace weft::validate {

bool Measure::holds() const {
  if (!std::isfinite(value)) return false;
  const double allowed = tolerance * (expected == 0 ? 1 : std::abs(expected));
  const double beyond = value - expected;
  switch (bound) {
    case Bound::AtMost:
      return beyond <= allowed;
    case Bound::AtLeast:
      return beyond >= -allowed;
    default:
      return std::abs(beyond) <= allowed;
  }
}

bool Rig::takes_fabric() const {
  const auto& takes = method_of(solver).takes;
  return std::find(takes.begin(), takes.end(), ElementKind::Membrane) != takes.end();
}

bool Rig::takes(scene::FabricEnergy energy) const { return takes_energy(method_of(solver), energy); }

std::span<const Law> laws() {
  static constexpr std::array kLaws = {
      Law{"stretch", "A strip that hangs stretches by w L²/2E, and narrows by Poisson's ratio", true,
          measure_stretch},
      Law{"bias", "A strip cut at 45° has 1/E = (1/E1 + 1/E2 - 2ν/E1 + 1/G)/4", true, measure_bias},
      Law{"catenary", "A rope between level ends hangs as a catenary", false, measure_catenary},
      Law{"cantilever", "A heavy strip clamped level hangs as the elastica", true, measure_cantilever},
      Law{"refine", "Half the cell leaves a quarter of the error, on every pattern of triangles", true,
          measure_refine, false},
      Law{"standing", "A strip stands below w L³/B = 7.8373 (Greenhill 1881), and falls above: the elastica",
          true, measure_standing, false},
      Law{"twist", "A heavy strip aslant bends and twists as Kirchhoff's rod (1859)", true, measure_twist,
          false},
      Law{"lateral",
          "A strip on edge stands below w L³/B = 12.85 sqrt(4 D33/B) (Timoshenko), and turns aside above",
          true, measure_lateral, false},
      Law{"fall", "A free sheet falls by g t²/2, with drag by g/c (t - (1 - exp(-c t))/c)", false,
          measure_fall},
      Law{"chain", "A hanging rope swings with ω = 2.4048/2 sqrt(g/L) (Bernoulli 1733)", false,
          measure_chain},
      Law{"pendulum", "A stiff sheet swings with ω = sqrt(3g/2L)", true, measure_pendulum},
      Law{"wave", "A free strip rings along itself with f = sqrt(E/ρ)/2L", false, measure_wave},
      Law{"throw", "Nothing acts on a thrown sheet: energy, momentum and spin stay", false, measure_throw},
      Law{"order", "Half the step leaves a quarter of the error (implicit), or half (others)", false,
          measure_order},
      Law{"slope", "On a slope cloth rests below µ, and slides above with g (sin - µ cos)", false,
          measure_slope},
      Law{"landing", "Friction takes µ times what the floor presses, whatever the blow (Coulomb)", false,
          measure_landing},
      Law{"capstan", "A rope over a rail is held up to exp(µπ), and slides beyond (Euler, Eytelwein)", false,
          measure_capstan}};
  return kLaws;
}

Result<void> measure_laws(const Rig& rig, std::span<const std::string> names,
                          const std::function<Result<void>(const Row&)>& tell) {
  for (const Law& law : laws()) {
    if (!names.empty() && std::find(names.begin(), names.end(), law.name) == names.end()) continue;
    if (law.of_fabric && !rig.takes_fabric()) continue;
    if (names.empty() && !law.of_sweeps && method_of(rig.solver).sweeps) continue;
    auto measures = law.measure(rig);
    if (!measures && measures.error().kind == ErrorKind::Diverged)
      measures = std::vector<Measure>{{"its cloth diverged", "", std::numeric_limits<double>::quiet_NaN()}};
    if (!measures) return measures.error().while_doing("measuring the law \"" + std::string(law.name) + "\"");
    for (Measure& measure : *measures) WEFT_CHECK(tell({&law, rig.solver, std::move(measure)}));
  }
  return {};
}

}  // namespace weft::validate
