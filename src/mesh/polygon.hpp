// A polygon's triangles, made while its corners are read, so that no polygon is ever stored.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Appends the fan of a polygon to `triangles`, one triangle for each corner from the third on:
///
///     3───2      corners 0 1 2 3
///     │ ╱ │      triangles (0 1 2), (0 2 3)
///     0───1
class PolygonFan {
 public:
  explicit PolygonFan(std::vector<Triangle>& triangles) : triangles_(triangles) {}

  void add(std::uint32_t vertex) {
    if (corner_count_ == 0) first_ = vertex;
    if (corner_count_ >= 2) triangles_.push_back({first_, last_, vertex});
    last_ = vertex;
    ++corner_count_;
  }
  std::uint64_t corner_count() const { return corner_count_; }

 private:
  std::vector<Triangle>& triangles_;
  std::uint64_t corner_count_ = 0;
  std::uint32_t first_ = 0;
  std::uint32_t last_ = 0;
};

/// The number of triangles in the fan of a polygon.
constexpr std::uint64_t fan_size(std::uint64_t corner_count) {
  return corner_count < 3 ? 0 : corner_count - 2;
}

}  // namespace weft::mesh
