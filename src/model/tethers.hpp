// How far the nodes of a cloth may be from what holds it: no farther than the way there along the cloth at rest, as a
// sheet that does not stretch. Source: docs/solvers/xpbd.md, Tethers.
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// Islands of held nodes that a node is tethered to, at most.
inline constexpr std::size_t kMostTethers = 4;

struct Tether {
  std::uint32_t to = 0;  // a pinned or moved node
  double length = 0;     // [m]
  bool operator==(const Tether&) const = default;
};

/// The tethers of every node: row v has those of node v, by the numbers of the nodes that hold it.
struct TetherRows {
  std::vector<std::uint32_t> starts;  // one more than there are nodes
  std::vector<Tether> tethers;

  bool any() const { return !tethers.empty(); }
};

/// Of all bodies that have them. Held nodes that an edge joins and one motion moves are an island; a node has a tether
/// to the nearest node of each of the nearest islands.
TetherRows tethers_of(const Model& model);

}  // namespace weft
