#include "method/multigrid/element_pairs.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

#include "model/cords.hpp"

namespace weft {
namespace {

struct PlacedPart {
  std::uint32_t row, column;  // nodes
  ElementPart part;

  bool is_own() const { return row == column; }
  auto order() const {
    return std::tuple(!is_own(), row, column, part.kind, part.element);  // nodes before pairs
  }
};

/// Those of an element, whose nodes count from `first`.
void add_parts(PartKind kind, std::uint32_t element, std::span<const std::uint32_t> nodes,
               std::uint32_t first, std::vector<PlacedPart>& parts) {
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
    for (std::uint32_t j = 0; j < nodes.size(); ++j)
      if (nodes[i] <= nodes[j]) parts.push_back({nodes[i] - first, nodes[j] - first, {kind, element, i, j}});
}

void add_parts(PartKind kind, ElementKind elements, const Model& model, const multigrid::SystemBodies& bodies,
               std::vector<PlacedPart>& parts) {
  std::uint32_t number = 0;
  for (const Body& body : bodies.bodies) {
    const ElementTable& table = model.elements(elements, body);
    for (std::uint32_t e = 0; e < table.size(); ++e)
      add_parts(kind, number++, table.nodes_of(e), bodies.first_vertex(), parts);
  }
}

}  // namespace

ElementPairs element_pairs(const Model& model, const multigrid::SystemBodies& bodies) {
  std::vector<PlacedPart> parts;
  add_parts(PartKind::Membrane, ElementKind::Membrane, model, bodies, parts);
  add_parts(PartKind::Hinge, ElementKind::Hinge, model, bodies, parts);
  add_parts(PartKind::Tet, ElementKind::Tet, model, bodies, parts);
  const std::vector<Cord> cords = cords_of(model, bodies.first());
  for (std::uint32_t e = 0; e < cords.size(); ++e)
    add_parts(PartKind::Cord, e, std::array{cords[e].a, cords[e].b}, 0, parts);
  std::sort(parts.begin(), parts.end(),
            [](const PlacedPart& a, const PlacedPart& b) { return a.order() < b.order(); });
  ElementPairs made;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const PlacedPart& here = parts[p];
    made.parts.items.push_back(here.part);
    if (p + 1 < parts.size() && parts[p + 1].row == here.row && parts[p + 1].column == here.column) continue;
    made.parts.close();
    if (!here.is_own()) made.pairs.push_back({here.row, here.column});
  }
  return made;
}

}  // namespace weft
