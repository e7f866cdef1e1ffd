#include "contact/proximity/feature_rings.hpp"

#include <algorithm>

#include "mesh/adjacency.hpp"
#include "state/contact_pairs.hpp"

namespace weft::contact {

std::vector<std::uint32_t> feature_rings(std::size_t vertex_count, std::span<const mesh::Triangle> cloth,
                                         std::size_t point_count, std::span<const mesh::Triangle> colliders) {
  const auto first_point = static_cast<std::uint32_t>(vertex_count);
  std::vector<mesh::Triangle> triangles(cloth.begin(), cloth.end());
  for (const auto& [a, b, c] : colliders)
    triangles.push_back({first_point + a, first_point + b, first_point + c});
  const mesh::Adjacency at = mesh::triangle_adjacency(vertex_count + point_count, triangles);
  const auto id_of = [&](std::uint32_t row) {
    return row < first_point ? row : kColliderPoint | (row - first_point);
  };
  std::vector<std::uint32_t> words;
  words.reserve(at.offsets.size() + 2 * at.entries.size());
  for (const std::uint32_t offset : at.offsets)
    words.push_back(static_cast<std::uint32_t>(at.offsets.size()) + 2 * offset);
  for (std::uint32_t row = 0; row < at.row_count(); ++row)
    for (const std::uint32_t t : at.row(row)) {
      const mesh::Triangle& corners = triangles[t];
      const auto k =
          static_cast<std::size_t>(std::find(corners.begin(), corners.end(), row) - corners.begin());
      words.push_back(id_of(corners[(k + 1) % 3]));
      words.push_back(id_of(corners[(k + 2) % 3]));
    }
  return words;
}

}  // namespace weft::contact
