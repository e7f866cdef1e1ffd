// The gas in a closed cloth, in double. Source: docs/pressure.md, equations 1 to 3.
#pragma once

#include <algorithm>
#include <cmath>

namespace weft::gas {

/// A smaller volume, by that at rest, counts as this: of a cloth that lies flat, and has no inside.
inline constexpr double kLeastVolume = 0.01;  // mirror: src/method/gas.wgsl

/// Ideal at constant temperature, or of one gauge pressure at any volume.
struct Law {
  double rest_volume = 0;    // [m³]
  double rest_pressure = 0;  // absolute, at that volume [Pa]; 0: the gauge pressure never changes
  double rest_gauge = 0;     // above that outside [Pa]

  double counted(double volume) const { return std::max(volume, kLeastVolume * rest_volume); }
  /// Above the pressure outside [Pa].
  double gauge(double volume) const {
    if (rest_pressure == 0) return rest_gauge;
    const double counts = counted(volume);
    return rest_gauge + rest_pressure * (rest_volume - counts) / counts;
  }
  /// By how much it falls with the volume [Pa/m³].
  double stiffness(double volume) const {
    if (rest_pressure == 0) return 0;
    const double counts = counted(volume);
    return rest_pressure * rest_volume / (counts * counts);
  }
  /// What the gas has more, and the air outside, than at rest [J].
  double energy(double volume) const {
    const double more = volume - rest_volume;
    if (rest_pressure == 0) return -rest_gauge * more;
    const double counts = counted(volume);
    return (rest_pressure - rest_gauge) * (counts - rest_volume) -
           rest_pressure * rest_volume * std::log(counts / rest_volume) - gauge(volume) * (volume - counts);
  }
};

}  // namespace weft::gas
