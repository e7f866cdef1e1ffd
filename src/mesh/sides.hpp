// The triangles at each edge, in a fixed order.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// One triangle at an edge.
struct Side {
  std::array<std::uint32_t, 2> nodes{};  // the edge, the lower first
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;  // of the triangle, opposite the edge

  /// Of the triangle's corners, the one from which the edge goes to the next.
  std::uint32_t start() const { return (corner + 1) % 3; }
};

/// Three a triangle, sorted by edge, there by triangle and corner, so that the sides of an edge lie together. An edge
/// may lead from a node to itself.
std::vector<Side> sorted_sides(std::span<const Triangle> triangles);

/// visit(sides) with those of each edge in turn.
template <class Visit>
void for_each_edge(std::span<const Side> sorted, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].nodes == sorted[begin].nodes) ++end;
    visit(sorted.subspan(begin, end - begin));
  }
}

}  // namespace weft::mesh
