// Nodes that become one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace weft {

/// The groups that pairs of nodes make; each is known by its lowest node.
class NodeGroups {
 public:
  explicit NodeGroups(std::size_t nodes) : lower_(nodes) { std::iota(lower_.begin(), lower_.end(), 0U); }

  std::uint32_t of(std::uint32_t node) const {
    while (lower_[node] != node) node = lower_[node] = lower_[lower_[node]];
    return node;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({of(a), of(b)});
    lower_[high] = low;
  }

 private:
  mutable std::vector<std::uint32_t>
      lower_;  // one of the same group, or the node itself; nearer with each look
};

}  // namespace weft
