#include "mesh/adjacency.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace weft::mesh {
namespace {

// Counting sort: count, sum, fill in the order of the items, which leaves each row ascending.
template <class Item, class Rows>
Adjacency build(std::size_t row_count, std::span<const Item> items, Rows rows_of) {
  Adjacency adjacency;
  adjacency.offsets.assign(row_count + 1, 0);
  std::size_t entry_count = 0;
  for (const Item& item : items)
    for (const std::uint32_t row : rows_of(item)) {
      assert(row < row_count);
      ++adjacency.offsets[row + 1];
      ++entry_count;
    }
  assert(entry_count <= std::numeric_limits<std::uint32_t>::max());
  for (std::size_t row = 0; row < row_count; ++row) adjacency.offsets[row + 1] += adjacency.offsets[row];
  adjacency.entries.resize(entry_count);
  std::vector<std::uint32_t> next(adjacency.offsets.begin(), adjacency.offsets.end() - 1);
  for (std::uint32_t index = 0; index < items.size(); ++index)
    for (const std::uint32_t row : rows_of(items[index])) adjacency.entries[next[row]++] = index;
  return adjacency;
}

}  // namespace

Adjacency spring_adjacency(std::size_t node_count, std::span<const MeshSpring> springs) {
  return build(node_count, springs, [](const MeshSpring& s) { return Edge{s.node_a, s.node_b}; });
}

Adjacency triangle_adjacency(std::size_t vertex_count, std::span<const Triangle> triangles) {
  return build(vertex_count, triangles, [](const Triangle& t) { return t; });
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
