#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace weft {

/// Lists one after the other.
template <class Item>
struct Lists {
  std::vector<std::uint32_t> starts = {0};  // one more than there are lists
  std::vector<Item> items;

  std::size_t size() const { return starts.size() - 1; }
  std::span<const Item> of(std::size_t list) const {
    return std::span(items).subspan(starts[list], starts[list + 1] - starts[list]);
  }
  /// Ends the list to which items were added.
  void close() { starts.push_back(static_cast<std::uint32_t>(items.size())); }
};

}  // namespace weft
