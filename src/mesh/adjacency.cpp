#include "mesh/adjacency.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace weft::mesh {

// Counting sort: count, sum, fill in the order of the triangles, which leaves each row ascending.
Adjacency triangle_adjacency(std::size_t vertex_count, std::span<const Triangle> triangles) {
  Adjacency adjacency;
  adjacency.offsets.assign(vertex_count + 1, 0);
  std::size_t entry_count = 0;
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t row : triangle) {
      assert(row < vertex_count);
      ++adjacency.offsets[row + 1];
      ++entry_count;
    }
  assert(entry_count <= std::numeric_limits<std::uint32_t>::max());
  for (std::size_t row = 0; row < vertex_count; ++row) adjacency.offsets[row + 1] += adjacency.offsets[row];
  adjacency.entries.resize(entry_count);
  std::vector<std::uint32_t> next(adjacency.offsets.begin(), adjacency.offsets.end() - 1);
  for (std::uint32_t index = 0; index < triangles.size(); ++index)
    for (const std::uint32_t row : triangles[index]) adjacency.entries[next[row]++] = index;
  return adjacency;
}

std::vector<Edge> mesh_edges(std::span<const Triangle> triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::uint32_t a = t[k], b = t[(k + 1) % 3]; a != b)
        edges.push_back({std::min(a, b), std::max(a, b)});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace weft::mesh
