#include "element/incidence.hpp"

namespace weft {

mesh::Adjacency places_in(std::span<const std::uint32_t> nodes, std::uint32_t first, std::size_t count) {
  mesh::Adjacency made;
  made.offsets.assign(count + 1, 0);
  for (const std::uint32_t node : nodes) ++made.offsets[node - first + 1];
  for (std::size_t row = 0; row < count; ++row) made.offsets[row + 1] += made.offsets[row];
  made.entries.resize(nodes.size());
  std::vector<std::uint32_t> next(made.offsets.begin(), made.offsets.end() - 1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    made.entries[next[nodes[i] - first]++] = static_cast<std::uint32_t>(i);
  return made;
}

mesh::Adjacency incidence(const ElementTable& table, std::uint32_t first, std::size_t count) {
  mesh::Adjacency made = places_in(table.nodes, first, count);
  for (std::uint32_t& entry : made.entries) entry /= table.arity();
  return made;
}

}  // namespace weft
