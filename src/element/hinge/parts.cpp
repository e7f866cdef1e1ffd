#include "element/hinge/parts.hpp"

#include <algorithm>

namespace weft::hinge {
namespace {

Part part_at(const Plate& plate, const Facet& facet, std::size_t corner) {
  Part part;
  const std::uint32_t own = facet.hinges[corner];
  if (own == kNone) return part;
  const Hinge& hinge = plate.hinges[own];
  part.hinges[0] = own;
  part.weights[0] = 0.5 + facet.sign[corner] * hinge.shift[0];
  for (std::size_t k = 0; k < 4; ++k) {
    if (hinge.others[k] == kNone) continue;
    part.hinges[k + 1] = hinge.others[k];
    part.weights[k + 1] = facet.sign[corner] * hinge.shift[k + 1];
  }
  return part;
}

}  // namespace

std::array<Part, 3> parts_of(const Plate& plate, const Facet& facet) {
  return {part_at(plate, facet, 0), part_at(plate, facet, 1), part_at(plate, facet, 2)};
}

Vec3d angles_of(const std::array<Part, 3>& parts, std::span<const double> bends) {
  Vec3d angles;
  for (int i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 5; ++k) {
      const Part& part = parts[static_cast<std::size_t>(i)];
      angles[i] += part.weights[k] * bends[part.hinges[k]];
    }
  return angles;
}

Vec3d weights_in(const std::array<Part, 3>& parts, std::uint32_t hinge) {
  Vec3d own;
  for (int i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 5; ++k) {
      const Part& part = parts[static_cast<std::size_t>(i)];
      if (part.hinges[k] == hinge) own[i] += part.weights[k];
    }
  return own;
}

std::vector<std::uint32_t> facets_of(const Plate& plate, std::uint32_t number) {
  std::vector<std::uint32_t> facets;
  const Hinge& hinge = plate.hinges[number];
  facets.assign(hinge.triangles.begin(), hinge.triangles.end());
  for (const std::uint32_t other : hinge.others)
    if (other != kNone)
      facets.insert(facets.end(), plate.hinges[other].triangles.begin(), plate.hinges[other].triangles.end());
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

}  // namespace weft::hinge
