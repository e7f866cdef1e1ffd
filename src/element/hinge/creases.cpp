#include "element/hinge/creases.hpp"

#include <cmath>

#include "element/hinge/parts.hpp"

namespace weft::hinge {

/// Equation 24.
void yield(const Plate& plate, const Yield& law, std::span<const double> bends, std::span<Crease> creases) {
  if (bends.empty()) return;
  for (std::size_t f = 0; f < plate.facets.size(); ++f) {
    Crease& crease = creases[f];
    const Vec3d elastic = angles_of(parts_of(plate, plate.facets[f]), bends) - crease.parts;
    const double curvature = std::sqrt(std::max(0.0, dot(elastic, plate.facets[f].curving * elastic)));
    const double kept = law.kept(curvature, crease.spent);
    if (kept <= 0) continue;
    crease.parts += kept / curvature * elastic;
    crease.spent += kept;
  }
}

std::vector<Coupling> crease_couplings(const Plate& plate) {
  std::vector<Coupling> all;
  for (std::uint32_t h = 0; h < plate.hinges.size(); ++h)
    for (const std::uint32_t f : facets_of(plate, h)) {
      const Facet& facet = plate.facets[f];
      const Vec3d by_part = facet.stiffness * weights_in(parts_of(plate, facet), h);  // which is symmetric
      for (int side = 0; side < 3; ++side)
        if (by_part[side] != 0) all.push_back({h, 3 * f + static_cast<std::uint32_t>(side), -by_part[side]});
    }
  return all;
}

}  // namespace weft::hinge
