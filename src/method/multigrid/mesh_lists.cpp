#include "method/multigrid/mesh_lists.hpp"

#include "method/multigrid/cycle.hpp"

namespace weft {
namespace {

/// Puts lists behind others, and returns where their starts begin.
template <class Item>
std::uint32_t append(const Lists<Item>& lists, std::vector<std::uint32_t>& starts, std::vector<Item>& items) {
  const auto first = static_cast<std::uint32_t>(starts.size());
  const auto offset = static_cast<std::uint32_t>(items.size());
  for (const std::uint32_t start : lists.starts) starts.push_back(offset + start);
  items.insert(items.end(), lists.items.begin(), lists.items.end());
  return first;
}

/// Puts the rows of a level behind others. Returns the entries of its blocks.
std::vector<BlockEntries> append_rows(const MeshLevel& level, MeshLists& lists) {
  std::vector<BlockEntries> entries_of(level.block_count);
  const auto append_entry = [&](std::uint32_t node) {
    lists.entries.push_back(node);
    return static_cast<std::uint32_t>(lists.entries.size() - 1);
  };
  for (std::uint32_t node = 0; node < level.node_count; ++node) {
    const std::uint32_t own = append_entry(node);
    lists.row_starts.push_back(own);
    entries_of[node] = {own, own};
    for (const Coupling& coupling : level.rows.of(node))
      entries_of[coupling.at.block][coupling.at.transposed ? 1 : 0] = append_entry(coupling.node);
  }
  lists.row_starts.push_back(static_cast<std::uint32_t>(lists.entries.size()));
  return entries_of;
}

}  // namespace

MeshLists mesh_lists(std::span<const MeshLevel> levels, bool air, bool volume) {
  MeshLists lists;
  for (const MeshLevel& level : levels) {
    MeshLevelParams made;
    made.node_count = level.node_count;
    made.block_count = level.block_count;
    made.first_vector = static_cast<std::uint32_t>(lists.vector_count);
    made.first_row = static_cast<std::uint32_t>(lists.row_starts.size());
    made.first_source = append(level.sources, lists.source_starts, lists.sources);
    Lists<Share> products{level.products.starts, {}};
    for (const auto& [at, weight] : level.products.items)
      products.items.push_back({lists.entries_of.back()[at.block][at.transposed ? 1 : 0], weight});
    made.first_product = append(products, lists.product_starts, lists.products);
    lists.entries_of.push_back(append_rows(level, lists));
    made.first_taps = static_cast<std::uint32_t>(lists.taps.size());
    for (const mesh::Taps& taps : level.taps)
      lists.taps.insert(lists.taps.end(), taps.begin(), taps.begin() + multigrid::taps_of(volume));
    lists.vector_count += std::size_t{multigrid::vector_count(lists.levels.size(), air)} * level.node_count;
    lists.levels.push_back(made);
  }
  return lists;
}

}  // namespace weft
