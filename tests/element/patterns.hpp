// Flat rectangular sheets, triangulated in the ways that tell bending rules apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft {

enum class Pattern { Equilateral, OneDiagonal, Alternating, Irregular };
inline constexpr std::array kPatterns = {Pattern::Equilateral, Pattern::OneDiagonal, Pattern::Alternating,
                                         Pattern::Irregular};
inline std::string name_of(Pattern pattern) {
  constexpr std::array kNames = {"equilateral", "one diagonal", "alternating", "irregular"};
  return kNames[static_cast<std::size_t>(pattern)];
}

/// From x = 0 to length and y = 0 to width, with `clamped` columns of cells before and `beyond` after. The nodes of
/// every pattern lie in columns, but for irregular ones inside, which are up to 0.3 cells off.
struct PatternSheet {
  double length = 1, width = 1;  // [m]
  double cell = 1;               // the distance of columns [m]
  std::vector<Vec3d> position;
  std::vector<mesh::Triangle> triangles;

  double area_of(std::size_t t) const {
    const auto& [a, b, c] = triangles[t];
    return weft::length(cross(position[b] - position[a], position[c] - position[a])) / 2;
  }
  bool inside(std::uint32_t node, double margin) const {
    const Vec3d& p = position[node];
    return p.x > margin && p.x < length - margin && p.y > margin && p.y < width - margin;
  }
};

/// Columns of `across` and `across + 1` cells in turn; the short ones at both rims are halves.
inline PatternSheet equilateral_sheet(double length, int along, int across, int clamped, int beyond) {
  PatternSheet sheet{length, across * 2 / std::sqrt(3.0) * length / along, length / along, {}, {}};
  const double step = sheet.width / across;
  std::vector<std::uint32_t> first;
  for (int i = -clamped; i <= along + beyond; ++i) {
    first.push_back(static_cast<std::uint32_t>(sheet.position.size()));
    const bool odd = (i + clamped) % 2 == 1;
    for (int j = 0; j <= across + (odd ? 1 : 0); ++j) {
      const double y = odd ? std::clamp(j - 0.5, 0.0, static_cast<double>(across)) : j;
      sheet.position.push_back({i * sheet.cell, y * step, 0});
    }
  }
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    const auto n = static_cast<std::uint32_t>(across);
    const std::uint32_t here = first[i], next = first[i + 1];
    for (std::uint32_t j = 0; j <= n; ++j) {
      if (i % 2 == 0) {
        sheet.triangles.push_back({here + j, next + j, next + j + 1});
        if (j < n) sheet.triangles.push_back({here + j, next + j + 1, here + j + 1});
      } else {
        sheet.triangles.push_back({here + j, next + j, here + j + 1});
        if (j < n) sheet.triangles.push_back({here + j + 1, next + j, next + j + 1});
      }
    }
  }
  return sheet;
}

/// Whether the diagonal from a to c of a quad a b c d sees angles that sum to less than pi, as Delaunay's does.
inline bool delaunay(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const auto cotangent = [](const Vec3d& at, const Vec3d& p, const Vec3d& q) {
    return dot(p - at, q - at) / length(cross(p - at, q - at));
  };
  return cotangent(b, c, a) + cotangent(d, a, c) > 0;
}

inline PatternSheet quad_sheet(Pattern pattern, double length, int along, int across, int clamped, int beyond,
                               std::uint64_t seed) {
  PatternSheet sheet{length, across * length / along, length / along, {}, {}};
  Random random(seed);
  for (int i = -clamped; i <= along + beyond; ++i)
    for (int j = 0; j <= across; ++j) {
      const bool moves = pattern == Pattern::Irregular;
      const double x = moves && i > 0 && i < along ? random.uniform(-0.3, 0.3) : 0;
      const double y = moves && j > 0 && j < across ? random.uniform(-0.3, 0.3) : 0;
      sheet.position.push_back({(i + x) * sheet.cell, (j + y) * sheet.cell, 0});
    }
  const auto rows = static_cast<std::uint32_t>(across) + 1;
  for (std::uint32_t i = 0; i + 1 < sheet.position.size() / rows; ++i)
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
      const std::uint32_t a = i * rows + j, b = a + rows, c = b + 1, d = a + 1;
      const auto& p = sheet.position;
      const bool rising = pattern == Pattern::OneDiagonal   ? true
                          : pattern == Pattern::Alternating ? (i + j) % 2 == 0
                                                            : delaunay(p[a], p[b], p[c], p[d]);
      if (rising)
        sheet.triangles.insert(sheet.triangles.end(), {{a, b, c}, {a, c, d}});
      else
        sheet.triangles.insert(sheet.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  return sheet;
}

inline PatternSheet pattern_sheet(Pattern pattern, double length, int along, int across, int clamped = 0,
                                  int beyond = 0, std::uint64_t seed = 1) {
  return pattern == Pattern::Equilateral ? equilateral_sheet(length, along, across, clamped, beyond)
                                         : quad_sheet(pattern, length, along, across, clamped, beyond, seed);
}

}  // namespace weft
