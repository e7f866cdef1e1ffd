// Sheets for the tests of the double reference.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "element/reference/motion.hpp"

namespace weft {

inline constexpr std::array kEnergies = {membrane::Energy::Green, membrane::Energy::Yarn,
                                         membrane::Energy::NeoHookean};

/// Orthotropic cloth, soft enough for strains of some per cent.
inline reference::Sheet cloth_of(const PatternSheet& pattern,
                                 membrane::Energy energy = membrane::Energy::Yarn) {
  reference::Sheet sheet;
  sheet.rest = pattern.position;
  sheet.triangles = pattern.triangles;
  sheet.warp = {1, 0.4, 0};
  sheet.membrane = {energy, Stiffness::of({60, 40, 0.2, 15}), 0};
  sheet.bending = Stiffness::of({2e-4, 1e-4, 0.2, 6e-5});
  sheet.density = 0.2;
  return sheet;
}

/// Every node that is at or before x = 0.
inline std::vector<std::uint8_t> held_before_zero(const std::vector<Vec3d>& rest) {
  std::vector<std::uint8_t> held;
  for (const Vec3d& p : rest) held.push_back(p.x < 1e-9 ? 1 : 0);
  return held;
}

inline Vec3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// Bent, stretched and sheared: a roll with noise of a twentieth of a cell.
inline std::vector<Vec3d> crumpled(const PatternSheet& pattern, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3d> x;
  for (const Vec3d& p : pattern.position) {
    const double turn = p.x + 0.5 * p.y;
    x.push_back(Vec3d{1.05 * p.x, p.y + 0.05 * p.x, 0.2 * std::sin(3 * turn)} +
                random_vector(random, 0.05 * pattern.cell));
  }
  return x;
}

/// A turn about an axis (Rodrigues).
struct Turn {
  Vec3d axis;    // unit
  double angle;  // [rad]

  Vec3d operator()(const Vec3d& v) const {
    return std::cos(angle) * v + std::sin(angle) * cross(axis, v) +
           (1 - std::cos(angle)) * dot(axis, v) * axis;
  }
};
inline const Turn kTurn{Vec3d{2, -1, 2} / 3, 1.1};

inline double largest_difference(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
  double most = 0;
  for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, length(a[v] - b[v]));
  return most;
}

/// The order by which errors fall when a step is halved.
inline double order_of(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace weft
