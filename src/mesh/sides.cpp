#include "mesh/sides.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace weft::mesh {

// By the lower node first, in one pass, as there may be millions.
std::vector<Side> sorted_sides(std::span<const Triangle> triangles) {
  const auto lower = [&](std::uint32_t t, std::uint32_t k) {
    return std::min(triangles[t][k], triangles[t][(k + 1) % 3]);
  };
  std::vector<std::size_t> next(1, 0);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::size_t node = lower(t, k);
      if (node + 2 > next.size()) next.resize(node + 2, 0);
      ++next[node + 1];
    }
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::size_t> offsets = next;
  std::vector<Side> sides(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides[next[lower(t, k)]++] = {{std::min(a, b), std::max(a, b)}, t, (k + 2) % 3};
    }
  const auto before = [](const Side& a, const Side& b) {
    const std::uint32_t start_a = a.start(), start_b = b.start();
    return std::tie(a.nodes, a.triangle, start_a) < std::tie(b.nodes, b.triangle, start_b);
  };
  for (std::size_t n = 0; n + 1 < offsets.size(); ++n)
    std::sort(sides.begin() + std::ptrdiff_t(offsets[n]), sides.begin() + std::ptrdiff_t(offsets[n + 1]),
              before);
  return sides;
}

}  // namespace weft::mesh
