#include "method/projective_dynamics/node_pairs.hpp"

#include <algorithm>
#include <tuple>

#include "element/membrane/membranes.hpp"
#include "method/projective_dynamics/bounded_yarns.hpp"
#include "model/fabric.hpp"

namespace weft {

std::vector<NodePair> fabric_node_pairs(const Model& model, const Body& cloth) {
  std::vector<NodePair> all;
  const auto add = [&](std::uint32_t a, std::uint32_t b, double stretching, double bending) {
    if (stretching != 0 || bending != 0) all.push_back({std::min(a, b), std::max(a, b), stretching, bending});
  };
  const FabricSheet sheet = fabric_sheet(model, cloth);
  const auto membranes = membrane::Membranes::of(sheet.rest(), membrane_law(*cloth.fabric));
  const bounded_yarns::Bound bound = bounded_yarns::bound(membranes.law.stiffness);
  for (std::size_t t = 0; t < membranes.triangles.size(); ++t) {
    const membrane::Rest& rest = membranes.rests[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const MaterialPoint &at = rest.slope[i], &other = rest.slope[j];
      add(membranes.triangles[t][i], membranes.triangles[t][j],
          -rest.area * (bound.warp * at.warp * other.warp + bound.weft * at.weft * other.weft), 0);
    }
  }
  for (const hinge::Coupling& c : hinge::isometric_matrix(model.plate(cloth), sheet.position))
    if (c.row < c.column) add(c.row, c.column, 0, -c.entry);
  std::stable_sort(all.begin(), all.end(), [](const NodePair& one, const NodePair& other) {
    return std::tie(one.a, one.b) < std::tie(other.a, other.b);
  });
  std::vector<NodePair> pairs;
  for (const NodePair& part : all) {
    if (pairs.empty() || pairs.back().a != part.a || pairs.back().b != part.b) {
      pairs.push_back(part);
      continue;
    }
    pairs.back().stretching += part.stretching;
    pairs.back().bending += part.bending;
  }
  return pairs;
}

}  // namespace weft
