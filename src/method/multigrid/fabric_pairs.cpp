#include "method/multigrid/fabric_pairs.hpp"

#include <algorithm>
#include <tuple>

namespace weft {
namespace {

struct PlacedPart {
  std::uint32_t row, column;  // nodes
  ElementPart part;

  bool is_own() const { return row == column; }
  auto order() const {
    return std::tuple(!is_own(), row, column, part.is_hinge, part.element);  // nodes before pairs
  }
};

void add_parts(const ElementTable& table, bool is_hinge, std::uint32_t first,
               std::vector<PlacedPart>& parts) {
  for (std::uint32_t e = 0; e < table.size(); ++e) {
    const auto nodes = table.nodes_of(e);
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
      for (std::uint32_t j = 0; j < nodes.size(); ++j)
        if (nodes[i] <= nodes[j]) parts.push_back({nodes[i] - first, nodes[j] - first, {e, is_hinge, i, j}});
  }
}

}  // namespace

FabricPairs fabric_pairs(const Model& model, const Body& body) {
  std::vector<PlacedPart> parts;
  add_parts(model.elements(ElementKind::Membrane, body), false, body.first_vertex, parts);
  add_parts(model.elements(ElementKind::Hinge, body), true, body.first_vertex, parts);
  std::sort(parts.begin(), parts.end(),
            [](const PlacedPart& a, const PlacedPart& b) { return a.order() < b.order(); });
  FabricPairs made;
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
