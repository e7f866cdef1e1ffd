// Open patches in double: docs/contact.md, Patches.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/vec.hpp"
#include "contact/proximity/patch_table.hpp"

namespace weft {

inline constexpr double kOpen = 0.6, kFolded = 0.1;  // as src/contact/proximity/patches.wgsl

struct PatchAxes {
  Vec3d first, second;
};

inline Vec3d unit_of(const Vec3d& v) { return length(v) > 0 ? v / length(v) : Vec3d{}; }

/// Columns and rows of quads.
inline std::uint32_t columns_of(std::uint32_t size) { return size & 0xffffU; }
inline std::uint32_t rows_of(std::uint32_t size) { return size >> 16U; }

template <class Vec>
PatchAxes axes_of(const contact::PatchPlace& place, const std::vector<Vec>& positions) {
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return positions[place.patch_vertex + j * place.stride + i].template to<double>();
  };
  const std::uint32_t i = columns_of(place.patch_size), j = rows_of(place.patch_size);
  const Vec3d row = unit_of(at(i, 0) - at(0, 0) + at(i, j) - at(0, j)),
              column = unit_of(at(0, j) - at(0, 0) + at(i, j) - at(i, 0));
  const Vec3d sum = unit_of(row + column), difference = unit_of(row - column);
  return {std::sqrt(0.5) * (sum + difference), std::sqrt(0.5) * (sum - difference)};
}

/// λ of a triangle: the least eigenvalue of the symmetric part of Eᵀ F, from its places and those at rest by row and
/// column [m].
inline double openness(const std::array<Vec3d, 3>& at, const std::array<std::array<double, 2>, 3>& rest,
                       const PatchAxes& axes) {
  const double a = rest[1][0] - rest[0][0], b = rest[1][1] - rest[0][1], c = rest[2][0] - rest[0][0],
               d = rest[2][1] - rest[0][1], area = a * d - b * c;
  const Vec3d u = at[1] - at[0], v = at[2] - at[0];
  const Vec3d row = (d * u - b * v) / area, column = (a * v - c * u) / area;
  const double x = dot(axes.first, row), y = dot(axes.second, column),
               shear = 0.5 * (dot(axes.first, column) + dot(axes.second, row));
  return 0.5 * (x + y) - std::hypot(0.5 * (x - y), shear);
}

/// λ of a patch along axes; 0 where there is none.
template <class Vec>
double openness_of(const contact::PatchPlace& place, const std::vector<Vec>& positions,
                   const std::vector<mesh::Triangle>& triangles, const PatchAxes& axes) {
  if (place.patch_size == 0) return 0;
  double least = 1;
  for (const mesh::Triangle& t : triangles) {
    std::array<Vec3d, 3> at;
    std::array<std::array<double, 2>, 3> rest{};
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = t[k] % place.stride, j = t[k] / place.stride,
                          first = place.patch_vertex % place.stride,
                          below = place.patch_vertex / place.stride;
      inside = inside && i >= first && i <= first + columns_of(place.patch_size) && j >= below &&
               j <= below + rows_of(place.patch_size);
      at[k] = positions[t[k]].template to<double>();
      rest[k] = {i / static_cast<double>(place.per_width), j / static_cast<double>(place.per_height)};
    }
    if (inside) least = std::min(least, openness(at, rest, axes));
  }
  return least;
}

}  // namespace weft
