// Flat rectangular sheets, triangulated in the ways that tell bending rules apart.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft {

enum class Pattern { Equilateral, OneDiagonal, Alternating, Irregular };
inline constexpr std::array kPatterns = {Pattern::Equilateral, Pattern::OneDiagonal, Pattern::Alternating,
                                         Pattern::Irregular};
std::string name_of(Pattern pattern);

/// From x = 0 to length and y = 0 to width, with `clamped` columns of cells before and `beyond` after. The nodes of
/// every pattern lie in columns, but for irregular ones inside, which are up to 0.3 cells off.
struct PatternSheet {
  double length = 1, width = 1;  // [m]
  double cell = 1;               // the distance of columns [m]
  std::vector<Vec3d> position;
  std::vector<mesh::Triangle> triangles;

  mesh::TriangleMesh triangle_mesh() const;
  double area_of(std::size_t t) const {
    const auto& [a, b, c] = triangles[t];
    return weft::length(cross(position[b] - position[a], position[c] - position[a])) / 2;
  }
  bool inside(std::uint32_t node, double margin) const {
    const Vec3d& p = position[node];
    return p.x > margin && p.x < length - margin && p.y > margin && p.y < width - margin;
  }
};

/// `along` cells of the length and `across` of the width, which follows from them.
PatternSheet pattern_sheet(Pattern pattern, double length, int along, int across, int clamped = 0,
                           int beyond = 0, std::uint64_t seed = 1);

}  // namespace weft
