#include "model/cords.hpp"

#include <algorithm>

#include "element/spring/law.hpp"
#include "model/fabric.hpp"
#include "model/limited_edges.hpp"

namespace weft {

std::vector<Cord> limit_cords(const Model& model, const Body& body) {
  std::vector<Cord> cords;
  if (!body.fabric || !body.strain_limit) return cords;
  for (const LimitedEdge& edge : limited_edges(model, body))
    cords.push_back({edge.a - body.first_vertex, edge.b - body.first_vertex, edge.longest, 0, 0});
  const FabricSheet sheet = fabric_sheet(model, body);
  const RestSheet at_rest = sheet.rest();
  const Moduli moduli = membrane_moduli(*body.fabric);
  for (std::size_t number = 0; number < sheet.triangles.size(); ++number) {
    const mesh::Triangle& t = sheet.triangles[number];
    const auto at = at_rest.places(number);
    const double area = membrane::Rest::of(at).area;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      Cord* cord = find_edge(cords, std::min(t[k], t[next]), std::max(t[k], t[next]));
      if (cord == nullptr) continue;
      const double warp = at[next].warp - at[k].warp, weft = at[next].weft - at[k].weft;
      const double stiffness = modulus_along(moduli, warp, weft) * area / (warp * warp + weft * weft);
      cord->stiffness += static_cast<float>(spring::kStiffer * stiffness);
    }
  }
  return cords;
}

std::vector<Cord> cords_of(const Model& model, const Body& body) {
  std::vector<Cord> cords = limit_cords(model, body);
  if (!body.fabric) return cords;
  for (const Spring s : model.springs(body))
    cords.push_back({s.node_a - body.first_vertex, s.node_b - body.first_vertex, 0, s.stiffness, s.damping});
  return cords;
}

}  // namespace weft
