#include "method/projective_dynamics/node_pairs.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "element/membrane/membranes.hpp"
#include "method/projective_dynamics/bounded_yarns.hpp"
#include "model/fabric.hpp"
#include "model/solid.hpp"

namespace weft {
namespace {

/// Of two corners of a triangle [N/m].
double pull_by(const bounded_yarns::Bound& bound, const membrane::Rest& rest, std::size_t i, std::size_t j) {
  const MaterialPoint &at = rest.slope[i], &other = rest.slope[j];
  return -rest.area * (bound.warp * at.warp * other.warp + bound.weft * at.weft * other.weft);
}

/// Parts of the same pair become one.
std::vector<NodePair> summed(std::vector<NodePair> parts) {
  std::stable_sort(parts.begin(), parts.end(), [](const NodePair& one, const NodePair& other) {
    return std::tie(one.a, one.b) < std::tie(other.a, other.b);
  });
  std::vector<NodePair> pairs;
  for (const NodePair& part : parts) {
    if (pairs.empty() || pairs.back().a != part.a || pairs.back().b != part.b) {
      pairs.push_back(part);
      continue;
    }
    pairs.back().pull += part.pull;
    pairs.back().damping += part.damping;
    pairs.back().bending += part.bending;
  }
  return pairs;
}

}  // namespace

std::vector<NodePair> fabric_node_pairs(const Model& model, const Body& cloth) {
  std::vector<NodePair> all;
  const FabricSheet sheet = fabric_sheet(model, cloth);
  const auto membranes = membrane::Membranes::of(sheet.rest(), membrane_law(*cloth.fabric));
  const bounded_yarns::Bound bound = bounded_yarns::bound(membranes.law.stiffness),
                             damping = bounded_yarns::damping_bound(membranes.law.stiffness);
  for (std::size_t t = 0; t < membranes.triangles.size(); ++t) {
    const membrane::Rest& rest = membranes.rests[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const auto [a, b] = std::minmax({membranes.triangles[t][i], membranes.triangles[t][j]});
      all.push_back(
          {a, b, pull_by(bound, rest, i, j), membranes.law.delay * pull_by(damping, rest, i, j), 0});
    }
  }
  for (const hinge::Coupling& c : hinge::isometric_matrix(model.plate(cloth), sheet.position))
    if (c.row < c.column && c.entry != 0) all.push_back({c.row, c.column, -c.entry, 0, -c.entry});
  return summed(std::move(all));
}

std::vector<NodePair> solid_node_pairs(const Model& model, const Body& body) {
  std::vector<NodePair> all;
  const tet::Tets tets = body_tets(model, body);
  const double most = 2 * tets.law.mu + 3 * std::max(0.0, tets.law.lambda);
  for (std::size_t t = 0; t < tets.tets.size(); ++t) {
    const tet::Rest& rest = tets.rests[t];
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const auto [a, b] = std::minmax({tets.tets[t][i], tets.tets[t][j]});
        const double pull = -rest.volume * most * dot(rest.slope[i], rest.slope[j]);
        all.push_back({a, b, pull, tets.law.delay * pull, 0});
      }
  }
  return summed(std::move(all));
}

}  // namespace weft
