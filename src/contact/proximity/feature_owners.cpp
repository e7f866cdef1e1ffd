#include "contact/proximity/feature_owners.hpp"

#include <algorithm>
#include <array>

namespace weft::contact {

std::vector<std::uint32_t> feature_owners(std::span<const mesh::Triangle> triangles) {
  struct Feature {
    std::array<std::uint32_t, 2> vertices;  // twice the same: a corner
    std::uint32_t triangle, bit;
    bool operator<(const Feature& other) const {
      return vertices != other.vertices ? vertices < other.vertices : triangle < other.triangle;
    }
  };
  std::vector<Feature> features;
  features.reserve(6 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      features.push_back({{a, a}, t, 1U << k});
      features.push_back({{std::min(a, b), std::max(a, b)}, t, 8U << k});
    }
  std::sort(features.begin(), features.end());
  std::vector<std::uint32_t> owned(triangles.size(), 0);
  for (std::size_t i = 0; i < features.size(); ++i)
    if (i == 0 || features[i].vertices != features[i - 1].vertices)
      owned[features[i].triangle] |= features[i].bit;
  return owned;
}

}  // namespace weft::contact
