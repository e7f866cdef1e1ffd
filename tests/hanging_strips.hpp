// Strips of fabric that hang by the middle of their upper edge, and what their moduli say of them.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/vec.hpp"

namespace weft {

/// A grid of 5 x 21 nodes, 2 cm apart and 0.2 kg/m², in the plane xy, whose third node is held.
struct HangingStrip {
  std::string fabric;         // members, without bending and damping
  double modulus, narrowing;  // along the strip, whose length is the weft's [N/m]; by its extension
};

inline std::vector<HangingStrip> hanging_strips() {
  const std::string woven = R"("warp": 120, "weft": 60, "shear": 20, "poisson": 0.6)";
  return {{woven + R"(, "energy": "yarn")", 60, 0.3},
          {woven + R"(, "energy": "green")", 60, 0.3},
          {R"("warp": 50, "shear": 20, "poisson": 0.25, "energy": "neo_hookean")", 50, 0.25}};
}

/// Of a strip at rest under 9.81 m/s²: its lower half, rows 10 to 20, is far from the pin, and the weight below each
/// place pulls evenly across.
inline void check_hanging(const HangingStrip& strip, const std::vector<Vec3d>& place) {
  constexpr double kHalf = 0.2, kDensity = 0.2, kPull = 9.81;
  const double stretch = length(place[52] - place[102]) - kHalf;
  const double exact = kDensity * kPull * kHalf * kHalf / (2 * strip.modulus);
  const double strain = kDensity * kPull * 0.16 / strip.modulus;  // at row 12
  const double narrowing = (1 - length(place[60] - place[64]) / 0.08) / strain;
  MESSAGE("stretches by ", stretch / exact, " of it, narrows by ", narrowing, " of the extension");
  CHECK(stretch == doctest::Approx(exact).epsilon(0.02).scale(0));
  CHECK(narrowing == doctest::Approx(strip.narrowing).epsilon(0.02).scale(0));
}

}  // namespace weft
