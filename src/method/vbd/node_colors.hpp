#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// The nodes of a cloth by colours: no two of a colour are nodes of one element, so all of a colour
/// may move at once. Greedy, in the order of the nodes: at most one colour more than a node has others at its elements.
struct NodeColors {
  std::vector<std::uint32_t> starts = {0};  // one more than there are colours
  std::vector<std::uint32_t> nodes;         // of the scene; colour after colour, ascending in each

  std::uint32_t count() const { return static_cast<std::uint32_t>(starts.size() - 1); }
};
NodeColors color_nodes(const Model& model, const Body& cloth);

}  // namespace weft
