// The wind as two travelling waves, derived from a scene's `wind`. Adds, multiplies and roots only: the same
// bits on every machine. docs/solvers/mass_spring.md, equations 8 and 9.
#pragma once

#include <array>

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// A plane wave: its phase at x and t is gradient · x - rate t, in turns.
struct WindWave {
  Vec3d gradient;   // [1/m]
  double rate = 0;  // [1/s]
  Vec3d gust;       // what its crest adds to the wind [m/s]
};

/// w(x, t) = velocity + Σ wave(phase) gust.
struct WindField {
  Vec3d velocity;  // [m/s]
  std::array<WindWave, 2> waves;

  bool blows() const { return velocity != Vec3d{}; }
  /// Whether the wind changes with time and place.
  bool varies() const { return blows() && waves[0].gust != Vec3d{}; }
};

WindField wind_field(const Wind& wind);

/// The fractional part of a number of turns: in [0, 1).
double turn_part(double turns);

}  // namespace weft::scene
