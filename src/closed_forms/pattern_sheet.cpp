#include "closed_forms/pattern_sheet.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace weft {
namespace {

/// Columns of `across` and `across + 1` cells in turn; the short ones at both rims are halves.
PatternSheet equilateral_sheet(double length, int along, int across, int clamped, int beyond) {
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
bool delaunay(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const auto cotangent = [](const Vec3d& at, const Vec3d& p, const Vec3d& q) {
    return dot(p - at, q - at) / length(cross(p - at, q - at));
  };
  return cotangent(b, c, a) + cotangent(d, a, c) > 0;
}

PatternSheet quad_sheet(Pattern pattern, double length, int along, int across, int clamped, int beyond,
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

}  // namespace

std::string name_of(Pattern pattern) {
  constexpr std::array kNames = {"equilateral", "one diagonal", "alternating", "irregular"};
  return kNames[static_cast<std::size_t>(pattern)];
}

PatternSheet pattern_sheet(Pattern pattern, double length, int along, int across, int clamped, int beyond,
                           std::uint64_t seed) {
  return pattern == Pattern::Equilateral ? equilateral_sheet(length, along, across, clamped, beyond)
                                         : quad_sheet(pattern, length, along, across, clamped, beyond, seed);
}

mesh::TriangleMesh PatternSheet::triangle_mesh() const {
  mesh::TriangleMesh made;
  for (const Vec3d& p : position) made.positions.push_back(p.to<float>());
  made.triangles = triangles;
  return made;
}

}  // namespace weft
