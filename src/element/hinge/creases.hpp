// Bends that stay: what a facet of a plate keeps of its curvature once it was bent too far. In double.
// Source: docs/elements.md, Creases.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "element/hinge/plate.hpp"

namespace weft::hinge {

/// Up to which curvature a sheet springs back.
struct Yield {
  double curvature = 0;  // [1/m]
  double hardening = 0;  // how much it grows by all curvature that was kept

  /// What a facet keeps of an elastic curvature K [1/m]: K - kept = curvature + hardening (spent + kept).
  double kept(double elastic, double spent) const {
    return std::max(0.0, elastic - (curvature + hardening * spent)) / (1 + hardening);
  }
};

/// Of a facet.
struct Crease {
  Vec3d parts;       // of the angles at its edges, with which it has no moment [rad]
  double spent = 0;  // all curvature that it has kept, forth and back [1/m]
};

/// Takes into the creases what these bends leave for good, facet by facet. It takes from the energy, never adds to it,
/// and done again it changes nothing.
void yield(const Plate& plate, const Yield& law, std::span<const double> bends, std::span<Crease> creases);

/// What creases take off the moments, as a matrix by hinges and by three parts a facet, row by row with columns
/// ascending: moments = couplings * bends + this * parts [N·m].
std::vector<Coupling> crease_couplings(const Plate& plate);

}  // namespace weft::hinge
