// A strip that hangs from its top row: what methods that iterate must hold at rest, whatever they have left to do.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "gpu/gpu_fixture.hpp"
#include "solver_rig.hpp"

namespace weft {

/// After 4 s it is longer by what its springs say. `solver`: the scene's member, with its comma.
inline void check_hung_strip(gpu::Device& device, const std::string& solver) {
  CAPTURE(solver);
  constexpr double kGravity = 9.81;  // [m/s²]
  constexpr std::uint32_t kRows = 21;
  constexpr double kLength = 1, kDensity = 0.2, kStiffness = 2000, kCell = kLength / (kRows - 1);
  double drop = 0;  // each row's spring carries the rows below it and half the last
  for (std::uint32_t n = 0; n + 1 < kRows; ++n)
    drop += kDensity * kCell * kCell * kGravity * (kRows - 1.5 - n) / kStiffness;
  constexpr double h = 1.0 / 512;
  SolverRig rig(device, scene_of(solver + R"("drag": 10, "cloths": [{"grid": [5, 21], "size": [0.2, 1],
                  "density": 0.2, "damping": 0, "pins": ["top"],
                  "stiffness": {"structural": 2000, "shear": 0, "bend": 0}}])"),
                h);
  const double top = static_cast<double>(rig.positions()[2].y);
  rig.advance(static_cast<std::uint32_t>(std::lround(4 / h)));
  const double found = top - static_cast<double>(rig.positions()[(kRows - 1) * 5 + 2].y) - kLength;
  MESSAGE(found << " m, by its springs " << drop);
  CHECK(found == doctest::Approx(drop).epsilon(0.01).scale(0));
}

}  // namespace weft
