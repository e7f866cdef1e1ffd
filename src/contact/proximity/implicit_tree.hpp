// The layout of the boxes of an implicit tree (src/contact/proximity/tree.wgsl): the shape follows from the number of
// triangles alone.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.hpp"

namespace weft::contact {

/// 16 bytes of the buffer `trees`.
struct TreeWord {
  std::uint32_t x = 0, y = 0, z = 0, w = 0;
};
static_assert(sizeof(TreeWord) == 16);

inline constexpr std::uint32_t kTreeLeafTriangles = 4, kTreeArity = 8;

struct ImplicitTree {
  std::uint32_t first = 0;            // word
  std::vector<std::uint32_t> counts;  // boxes of each level, leaves first; the last has one

  explicit ImplicitTree(std::uint32_t triangle_count = 1, std::uint32_t first_word = 0);
  std::uint32_t top() const { return static_cast<std::uint32_t>(counts.size() - 1); }
  std::uint32_t leaf_count() const { return counts[0]; }
  /// The words that say where levels lie, then room for the boxes.
  std::vector<TreeWord> words() const;
};

}  // namespace weft::contact
