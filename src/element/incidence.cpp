#include "element/incidence.hpp"

namespace weft {

mesh::Adjacency incidence(const ElementTable& table, std::uint32_t first, std::size_t count) {
  mesh::Adjacency made;
  made.offsets.assign(count + 1, 0);
  for (const std::uint32_t node : table.nodes) ++made.offsets[node - first + 1];
  for (std::size_t row = 0; row < count; ++row) made.offsets[row + 1] += made.offsets[row];
  made.entries.resize(table.nodes.size());
  std::vector<std::uint32_t> next(made.offsets.begin(), made.offsets.end() - 1);
  for (std::size_t i = 0; i < table.nodes.size(); ++i)
    made.entries[next[table.nodes[i] - first]++] = static_cast<std::uint32_t>(i / table.arity());
  return made;
}

}  // namespace weft
