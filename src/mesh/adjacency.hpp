// Adjacency in CSR form, in a fixed order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// The entries of row i are entries[offsets[i]] up to entries[offsets[i + 1]], ascending.
struct Adjacency {
  std::vector<std::uint32_t> offsets;  // rows + 1
  std::vector<std::uint32_t> entries;

  std::size_t row_count() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const std::uint32_t> row(std::size_t index) const {
    return std::span<const std::uint32_t>(entries).subspan(offsets[index],
                                                           offsets[index + 1] - offsets[index]);
  }
};

/// Vertex -> the triangles at it. Three times the number of triangles is below 2^32.
Adjacency triangle_adjacency(std::size_t vertex_count, std::span<const Triangle> triangles);

using Edge = std::array<std::uint32_t, 2>;  // vertices, the lower first

/// Every edge of the triangles once, sorted.
std::vector<Edge> mesh_edges(std::span<const Triangle> triangles);

}  // namespace weft::mesh
