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

}  // namespace

MeshLists mesh_lists(const std::vector<MeshLevel>& levels) {
  MeshLists lists;
  for (const MeshLevel& level : levels) {
    MeshLevelParams made;
    made.node_count = level.node_count;
    made.block_count = level.block_count;
    made.first_vector = static_cast<std::uint32_t>(lists.vector_count);
    made.first_block = static_cast<std::uint32_t>(lists.block_count);
    made.first_row = append(level.rows, lists.row_starts, lists.rows);
    made.first_source = append(level.sources, lists.source_starts, lists.sources);
    made.first_product = append(level.products, lists.product_starts, lists.products);
    made.first_taps = static_cast<std::uint32_t>(lists.taps.size());
    for (const auto& taps : level.taps) lists.taps.insert(lists.taps.end(), taps.begin(), taps.end());
    lists.vector_count += std::size_t{multigrid::vector_count(lists.levels.size())} * level.node_count;
    lists.block_count += level.block_count;
    lists.levels.push_back(made);
  }
  return lists;
}

}  // namespace weft
