#include "element/colors.hpp"

#include <algorithm>
#include <bit>

namespace weft {
namespace {

constexpr std::uint32_t kBits = 64;

/// The colours that a node has, as bits: the first word of all nodes in one list, more where a node needs them.
class Taken {
 public:
  explicit Taken(std::size_t nodes) : words_(1, std::vector<std::uint64_t>(nodes, 0)) {}
  std::uint64_t word(std::size_t index, std::uint32_t node) const {
    return index < words_.size() ? words_[index][node] : 0;
  }
  void add(std::uint32_t color, std::uint32_t node) {
    while (words_.size() <= color / kBits) words_.emplace_back(words_[0].size(), 0);
    words_[color / kBits][node] |= std::uint64_t{1} << (color % kBits);
  }

 private:
  std::vector<std::vector<std::uint64_t>> words_;
};

}  // namespace

Colors color_elements(const ElementTable& table, std::size_t node_count) {
  Taken taken(node_count);
  std::vector<std::uint32_t> color_of(table.size());
  Colors colors;
  for (std::size_t element = 0; element < table.size(); ++element) {
    const std::span<const std::uint32_t> nodes = table.nodes_of(element);
    std::uint64_t used = ~std::uint64_t{0};
    std::uint32_t word = 0;
    for (; used == ~std::uint64_t{0}; ++word) {
      used = 0;
      for (const std::uint32_t node : nodes) used |= taken.word(word, node);
    }
    const std::uint32_t color = (word - 1) * kBits + static_cast<std::uint32_t>(std::countr_one(used));
    for (const std::uint32_t node : nodes) taken.add(color, node);
    color_of[element] = color;
    if (colors.count() <= color) colors.starts.resize(color + 2, 0);
    ++colors.starts[color + 1];
  }
  for (std::uint32_t color = 0; color < colors.count(); ++color)
    colors.starts[color + 1] += colors.starts[color];
  colors.elements.resize(table.size());
  std::vector<std::uint32_t> next(colors.starts.begin(), colors.starts.end() - 1);
  for (std::uint32_t element = 0; element < table.size(); ++element)
    colors.elements[next[color_of[element]]++] = element;
  return colors;
}

}  // namespace weft
