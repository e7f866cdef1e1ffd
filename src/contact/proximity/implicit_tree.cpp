#include "contact/proximity/implicit_tree.hpp"

namespace weft::contact {

ImplicitTree::ImplicitTree(std::uint32_t triangle_count, std::uint32_t first_word) : first(first_word) {
  counts.push_back((triangle_count + kTreeLeafTriangles - 1) / kTreeLeafTriangles);
  do {  // a walk starts above the leaves, so there are at least two levels
    counts.push_back((counts.back() + kTreeArity - 1) / kTreeArity);
  } while (counts.back() > 1);
}

std::vector<TreeWord> ImplicitTree::words() const {
  std::vector<TreeWord> words = {{top(), 0, 0, 0}};
  auto next = static_cast<std::uint32_t>(first + 1 + counts.size());
  for (const std::uint32_t count : counts) {
    words.push_back({next, count, 0, 0});
    next += 2 * count;
  }
  words.resize(next - first);
  return words;
}

}  // namespace weft::contact
