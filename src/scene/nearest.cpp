#include "scene/nearest.hpp"

#include <algorithm>
#include <vector>

namespace weft::scene {

// Optimal string alignment: d(i, j) from the first i letters of a to the first j of b, by rows.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two_up, up(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) up[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = up[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, up[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], two_up[j - 2] + 1);
    }
    two_up = up;
    up = row;
  }
  return up[b.size()];
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t kLongestWord = 64;  // no known word is near a longer one, and the cost is a product
  if (word.size() > kLongestWord) return {};
  constexpr std::size_t kShortestStart =
      3;  // "bending" means bend, "fov" means fov_degrees; "b" may mean anything
  const std::size_t limit = std::max<std::size_t>(1, (word.size() + 1) / 3);
  std::size_t least = limit + 1;
  std::string_view found;
  for (const std::string_view candidate : known) {
    std::size_t distance = edit_distance(word, candidate);
    const std::size_t shared = std::min(word.size(), candidate.size());
    if (shared >= kShortestStart && word.substr(0, shared) == candidate.substr(0, shared))
      distance = std::min(distance, limit);
    if (distance < least && distance < candidate.size()) {
      least = distance;
      found = candidate;
    }
  }
  return found;
}

}  // namespace weft::scene
