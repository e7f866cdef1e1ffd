#include "method/vbd/node_colors.hpp"

#include <algorithm>

namespace weft {

NodeColors color_nodes(const Model& model, const Body& cloth) {
  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> color(cloth.vertex_count, kNone);
  std::vector<std::vector<std::uint32_t>> of_color;
  std::vector<bool> taken;
  for (std::uint32_t node = 0; node < cloth.vertex_count; ++node) {
    taken.assign(of_color.size() + 1, false);
    for (const ElementKind kind :
         {ElementKind::Spring, ElementKind::Membrane, ElementKind::Hinge, ElementKind::Tet}) {
      const ElementTable& elements = model.elements(kind, cloth);
      if (elements.size() == 0) continue;
      for (const std::uint32_t at : model.incidence(kind, cloth).row(node))
        for (const std::uint32_t other : elements.nodes_of(at))
          if (color[other - cloth.first_vertex] != kNone) taken[color[other - cloth.first_vertex]] = true;
    }
    color[node] = static_cast<std::uint32_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    if (color[node] == of_color.size()) of_color.emplace_back();
    of_color[color[node]].push_back(cloth.first_vertex + node);
  }
  NodeColors colors;
  for (const auto& nodes : of_color) {
    colors.nodes.insert(colors.nodes.end(), nodes.begin(), nodes.end());
    colors.starts.push_back(static_cast<std::uint32_t>(colors.nodes.size()));
  }
  return colors;
}

}  // namespace weft
