#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "element/table.hpp"

namespace weft {

/// Elements of one colour share no node, so that a kernel may move the nodes of all of them at once.
struct Colors {
  std::vector<std::uint32_t> starts = {0};  // one more than there are colours
  std::vector<std::uint32_t> elements;      // colour after colour, ascending in each

  std::uint32_t count() const { return static_cast<std::uint32_t>(starts.size() - 1); }
  std::span<const std::uint32_t> of(std::uint32_t color) const {
    return std::span(elements).subspan(starts[color], starts[color + 1] - starts[color]);
  }
};

/// Greedy: elements in their order take the first colour that none of their nodes has yet. Nodes are below node_count.
/// The least number of colours is the most elements that a node has; greedy takes at most 1 + arity (that - 1).
Colors color_elements(const ElementTable& table, std::size_t node_count);

}  // namespace weft
